# SPDX-License-Identifier: MIT
from __future__ import annotations

import csv
import enum
import gzip
import json
import os
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _engine, _progress
from ._answer import Answer
from ._documents import Document, Named, Puzzle, dict_of, text_of
from ._trajectory import Trajectory

Documents = Union[str, "os.PathLike[str]", Iterable[Document]]


def solve(
    puzzle: Document,
    *,
    all: bool = False,
    first: bool = False,
    planner: str = "auto",
    budget: int = -1,
    no_robustness: bool = False,
    sensitivity: bool = False,
    path: bool = False,
    no_timing: bool = False,
    noise: str = "",
    depth: int = 3,
    plies: int = 1,
) -> Answer:
    """Finds the best shot of a puzzle. The flags are those of `bankshot solve`.

    puzzle:        a dict, JSON text or a Puzzle; lengths in metres, speeds in m/s, angles in degrees
    all:           return every distinct shot, best first
    first:         return the first shot found, not the best
    planner:       name of the planner; "auto" is the default
    budget:        maximum number of simulations; below 0: the puzzle's own
    no_robustness: leave out margin and success, which is faster
    sensitivity:   add how far a wrong coefficient of the table moves each arrival
    path:          add the points of each shot's path
    no_timing:     leave out time_us, so that equal input gives equal bytes
    noise:         player whose errors apply: "pro", "league" or "beginner"; "": the puzzle's own
    depth:         number of balls that the plan of a game looks at; 0 makes no plan
    plies:         number of pots after it that a shot of a game is chosen for: 1, or 2, which is slower

    Raises InvalidInput if the puzzle breaks a rule. Ctrl-C ends the search.
    """
    flags: Dict[str, Any] = dict(
        all=all,
        first=first,
        planner=planner,
        budget=budget,
        no_robustness=no_robustness,
        sensitivity=sensitivity,
        path=path,
        no_timing=no_timing,
        noise=noise,
        depth=depth,
        plies=plies,
    )
    text = text_of(puzzle)
    return Answer(text, flags, solved=_engine.solve(text, _engine.SolveFlags(**flags)))


def play(
    layout: Document,
    *,
    game: str = "rotation",
    group: Optional[str] = None,
    order: Optional[Sequence[Union[str, Sequence[str]]]] = None,
    **flags: Any,
) -> Answer:
    """Finds what to play, thinking of the next balls: `solve` with a game as target.

    layout: a puzzle; its target is replaced
    game:   "rotation", "any", "eight" with a group, or "list" with an order
    group:  "solids" or "stripes"
    order:  ids of balls one after the other; a list in it allows any of its balls
    flags:  those of `solve`

    `plan` of the answer holds the shots after the first.
    """
    target: Dict[str, Any] = {"game": game}
    if group is not None:
        target["group"] = group
    if order is not None:
        target["order"] = order
    return solve({**dict_of(layout), "target": target}, **flags)


def solve_all(puzzle: Document, **flags: Any) -> Answer:
    """Finds every distinct shot of a puzzle, best first: `solve` with all=True."""
    return solve(puzzle, all=True, **flags)


def solve_batch(
    puzzles: Documents, *, threads: int = 0, progress: Optional[bool] = None, **flags: Any
) -> List[Answer]:
    """Solves many puzzles on all cores and without the GIL. Returns the answers in order.

    puzzles:  dicts, texts or Puzzles; or the path of a file with one puzzle per line, compressed if it ends in .gz
    threads:  0: one per core
    progress: show a bar on standard error; None: only on a terminal or in a notebook
    flags:    those of `solve`

    An item that is no puzzle has the answer "invalid" in its place, and raises nothing. All answers are held in memory;
    for millions of puzzles use `bankshot batch`.
    """
    lines = _lines(puzzles)
    with _progress.bar(len(lines), progress) as tell:
        answers = _engine.solve_lines(lines, _engine.SolveFlags(**flags), threads, tell)
    return [Answer(puzzle, flags, text=answer) for puzzle, answer in zip(lines, answers)]


def simulate(scene: Document, *, rate: float = 60) -> Trajectory:
    """Simulates a shot: a scene with its "shot", as a dict, JSON text or a Scene.

    A puzzle joined with a shot of its answer is also valid.

    rate: points per second of the arrays; exact events are included as well
    """
    return Trajectory(scene, rate)


class End(enum.IntEnum):
    """The kind of end of a launch of `simulate_many`."""

    REST = 0
    UNTIL = 1  # a limit of the scene's "until"
    POCKETED = 2
    EVENTS = 3  # too many events
    INVALID = 4  # a number is not finite, the speed is not above 0, or the physics has no such spin


def simulate_many(
    scene: Document,
    speeds: npt.ArrayLike,
    angles: npt.ArrayLike,
    spins: Optional[npt.ArrayLike] = None,
    *,
    threads: int = 0,
) -> npt.NDArray[np.void]:
    """Simulates many launches of one scene, on all cores, without the GIL or a Python loop.

    scene:   as for `simulate`; its shot is not needed
    speeds:  m/s
    angles:  degrees, anticlockwise from +x; of the speeds' shape, or one that broadcasts with it
    spins:   of that shape with one more axis of three: top, side, masse, in units of natural roll; None: the scene's
    threads: 0: one per core

    Returns the ends of the cue ball: an array of that shape with the fields time s, length m, x m, y m, vx m/s,
    vy m/s, wx rad/s, wy rad/s, wz rad/s, cushions, kind (End) and pocket (its number on the table; -1: none).
    """
    speed, angle = np.broadcast_arrays(np.asarray(speeds, float), np.asarray(angles, float))
    spin = None
    if spins is not None:
        asked = np.asarray(spins, float)
        if asked.shape[-1:] != (3,):
            raise ValueError(f"spins must be rows of top, side and masse, and have the shape {asked.shape}")
        shape = np.broadcast_shapes(speed.shape, asked.shape[:-1])
        speed, angle = np.broadcast_to(speed, shape), np.broadcast_to(angle, shape)
        spin = np.broadcast_to(asked, shape + (3,)).reshape(-1, 3)
    document = {"shot": {"speed": 1, "angle": 0}, **dict_of(scene)}
    ends = _engine.simulate_many(text_of(document), speed.ravel(), angle.ravel(), spin, threads)
    return ends.reshape(speed.shape)


def verify(puzzle: Document, answer: Union[Answer, Document]) -> Dict[str, Any]:
    """Checks every claim of an answer against a replay in 50 digits.

    Returns {"holds": True, "checked": 14, "failed": []}. Each failed claim has the keys "shot", "claim", "off",
    "allowed" and "what".
    """
    text = answer.json if isinstance(answer, Answer) else text_of(answer)
    player = answer._flags.get("noise") if isinstance(answer, Answer) else ""
    asked = {**dict_of(puzzle), "noise": player} if player else puzzle
    report: Dict[str, Any] = json.loads(_engine.verify(text_of(asked), text))
    return report


def generate(
    count: int,
    seed: int,
    *,
    table: Named = "pool-9ft",
    physics: Named = "spin",
    cushions: Union[int, str, Tuple[int, int], Sequence[str]] = (1, 3),
    target: str = "",
    balls: int = 0,
    then: Union[int, str, Tuple[int, int], Sequence[str]] = 0,
    difficulty: str = "",
    unique: bool = False,
    no_spin: bool = False,
    speed: Sequence[float] = (),
    threads: int = 0,
) -> List[Puzzle]:
    """Makes puzzles that have a shot, with the flags of `bankshot generate`. The same seed gives the same puzzles.

    cushions:   a number; (least, most); or names in order
    target:     "pocket", "stop", "pass", "kick", "pot", "carom"; "": one of the first three is drawn
    balls:      number of other balls on the table
    then:       cushions of the object ball that is sent into a pocket ("pot"), given as for `cushions`
    difficulty: "easy", "medium", "hard"; "": any
    unique:     only puzzles with exactly one shot
    no_spin:    the cue ball is struck in the centre
    speed:      (lowest, highest) launch speed that a puzzle allows, in m/s; empty: any

    Raises LookupError if a puzzle is not found.
    """
    lines = _engine.generate(
        count,
        threads,
        seed=seed,
        table=_named(table),
        physics=_named(physics),
        cushions=_rule(cushions),
        target=target,
        balls=balls,
        then=_rule(then),
        difficulty=difficulty,
        unique=unique,
        no_spin=no_spin,
        speed=list(speed),
    )
    return [Puzzle.from_dict(json.loads(line)) for line in lines]


def map(puzzle: Document, columns: int = 40, rows: int = 20, *, budget: int = -1, no_robustness: bool = False, value: bool = False) -> npt.NDArray[np.void]:
    """Solves the puzzle from every start on a grid, on all cores, to show from where a shot can be made.

    Returns an array of `rows` by `columns`, from the lower left: map["success"][0, 0]. Its fields are the columns of
    docs/csv.md: x_m, y_m, status, speed_m_per_s, angle_deg, success and more; missing values are nan.
    With `value` nothing is solved: the fields are x_m, y_m, status, value, ball and pocket of the best straight pot.
    """
    flags = _engine.SolveFlags(budget=budget, no_robustness=no_robustness)
    table = list(csv.reader(_engine.map(text_of(puzzle), columns, rows, flags, value).splitlines()))
    cells = {name: [row[i] for row in table[1:]] for i, name in enumerate(table[0])}
    arrays = {
        name: np.array(column) if name in ("status", "cushions", "ball", "pocket") else np.array([float(c or "nan") for c in column])
        for name, column in cells.items()
    }
    out = np.empty(rows * columns, dtype=[(name, array.dtype) for name, array in arrays.items()])
    for name, array in arrays.items():
        out[name] = array
    return out.reshape(rows, columns)


_by_speed = ("as-given", "constant", "linear", "square")


def fit(
    recordings: Documents,
    *,
    free: Sequence[str] = (),
    model: str = "",
    restitution: str = "as-given",
    rolling: str = "as-given",
    holdout: int = 0,
    predict: bool = False,
    threads: int = 0,
) -> Dict[str, Any]:
    """Learns a table from recorded shots: returns the document of `bankshot fit`, with its flags (docs/recordings.md).

    Its "physics" can be used in a puzzle. recordings: dicts or texts, or the path of a file with one per line.
    Ctrl-C takes effect between steps. Raises RuntimeError if the module was built without BANKSHOT_LEARN.
    """
    if not _engine.learns:
        raise RuntimeError("this module was built without BANKSHOT_LEARN, and cannot fit")
    for word, allowed in ((restitution, _by_speed), (rolling, _by_speed[:-1])):
        if word not in allowed:
            raise ValueError(f'"{word}" is none of {", ".join(allowed)}')
    text = _engine.fit(
        [line for line in _lines(recordings) if line.strip()],
        free=list(free),
        model=model,
        restitution=_by_speed.index(restitution),
        rolling=_by_speed.index(rolling),
        holdout=holdout,
        predict=predict,
        threads=threads or os.cpu_count() or 1,
    )
    found: Dict[str, Any] = json.loads(text)
    return found


def schema(document: str = "puzzle") -> Dict[str, Any]:
    """Returns the JSON Schema of "puzzle", "shot", "answer", "recording" or "play"."""
    found: Dict[str, Any] = json.loads(_engine.schema(document))
    return found


def tables() -> List[Dict[str, Any]]:
    """Returns the preset tables: "name", "length" m, "width" m, "cushions", "pockets" in the order of their numbers."""
    found: List[Dict[str, Any]] = json.loads(_engine.tables())
    return found


def _lines(documents: Documents) -> List[str]:
    if isinstance(documents, (str, os.PathLike)):
        path = os.fspath(documents)
        with gzip.open(path, "rt", encoding="utf-8") if path.endswith(".gz") else open(path, encoding="utf-8") as file:
            return [line.rstrip("\n") for line in file]
    if isinstance(documents, Mapping):
        raise TypeError("a list of documents or the path of a file is needed, and this is one document")
    return [text_of(document) for document in documents]


def _named(value: Named) -> str:
    return value if isinstance(value, str) else text_of(value)


def _rule(value: Union[int, str, Tuple[int, int], Sequence[str]]) -> str:
    if isinstance(value, (int, str)):
        return str(value)
    between = "-" if isinstance(value[0], int) else ","
    return between.join(str(part) for part in value)
