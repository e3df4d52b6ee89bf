# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Union

from . import _engine
from ._documents import Document, Puzzle, Shot, dict_of, text_of
from ._trajectory import Trajectory, is_dark

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Answer:
    """The answer of `solve`: shots, best first, and the cost of the search.

    `answer.json` is the JSON of `bankshot solve --json`, which is parsed at first use. A notebook shows the answer as a
    picture; print(answer) shows it as text for a player.
    """

    def __init__(
        self,
        puzzle: Document,
        flags: Mapping[str, Any],
        text: Optional[str] = None,
        solved: Optional[_engine.Solved] = None,
    ) -> None:
        self._puzzle, self._flags, self._text, self._solved_by = text_of(puzzle), dict(flags), text, solved
        self._document: Optional[Dict[str, Any]] = None
        self._shots: Optional[List[Shot]] = None

    def _engines(self) -> _engine.Solved:
        """Solves the puzzle again if the answer came from a batch or a pickle; the same puzzle has the same answer."""
        if self._solved_by is None:
            self._solved_by = _engine.solve(self._puzzle, _engine.SolveFlags(**self._flags))
        return self._solved_by

    @property
    def json(self) -> str:
        """One line of JSON, byte for byte as the program prints it."""
        if self._text is None:
            self._text = self._engines().json()
        return self._text

    def to_dict(self) -> Dict[str, Any]:
        """Returns a new dict in the format of docs/format.md."""
        document: Dict[str, Any] = json.loads(self.json)
        return document

    def _get(self, key: str) -> Any:
        if self._document is None:
            self._document = self.to_dict()
        return self._document.get(key)

    @property
    def puzzle(self) -> Puzzle:
        return Puzzle.from_dict(dict_of(self._puzzle))

    @property
    def id(self) -> Union[None, str, int, float]:
        value: Union[None, str, int, float] = self._get("id")
        return value

    @property
    def status(self) -> str:
        """"solved", "no-shot", "budget", or "invalid" for a line of a batch that is no puzzle."""
        return str(self._get("status"))

    @property
    def solved(self) -> bool:
        return self.status == "solved"

    @property
    def shots(self) -> List[Shot]:
        """All shots, best first."""
        if self._shots is None:
            self._shots = [Shot.from_dict(shot) for shot in self._get("shots")]
        return self._shots

    @property
    def best(self) -> Optional[Shot]:
        """The best shot; None if there is no shot."""
        return self.shots[0] if self.shots else None

    @property
    def nearest(self) -> Optional[Shot]:
        """The nearest miss, if there is no shot."""
        miss = self._get("nearest")
        return Shot.from_dict(miss) if miss else None

    @property
    def plan(self) -> Optional[Dict[str, Any]]:
        """What is planned after the best shot of a game."""
        plan: Optional[Dict[str, Any]] = self._get("plan")
        return plan

    @property
    def message(self) -> str:
        """One sentence for a player."""
        return str(self._get("message"))

    @property
    def error(self) -> Optional[Dict[str, str]]:
        """The "path" and "reason" of the error, if the status is "invalid"."""
        error: Optional[Dict[str, str]] = self._get("error")
        return error

    @property
    def simulations(self) -> Optional[int]:
        """Simulations spent on search and verification."""
        count: Optional[int] = self._get("simulations")
        return count

    @property
    def time_us(self) -> Optional[float]:
        """Time of the search in microseconds; None with no_timing."""
        time: Optional[float] = self._get("time_us")
        return time

    def trajectory(self, shot: int = 0, rate: float = 60, to_target: bool = False) -> Trajectory:
        """Simulates one of the shots until all balls rest, or until the target is reached."""
        chosen = self.shots[shot]
        scene: Dict[str, Any] = {**dict_of(self._puzzle), "shot": chosen}
        if to_target:
            scene["until"] = {"time": chosen.arrival["time"]}
        return Trajectory(scene, rate)

    def __str__(self) -> str:
        return self.message if self.status == "invalid" else self._engines().text().rstrip("\n")

    def __repr__(self) -> str:
        if not self.shots:
            return f"<Answer {self.status}: {self.message}>"
        more = f", and {len(self.shots) - 1} more" if len(self.shots) > 1 else ""
        return f"<Answer {self.status}: {self.shots[0].in_words()}{more}>"

    def svg(self, theme: str = "light", words: bool = True, animate: bool = False) -> str:
        """Returns the picture of `bankshot solve --svg`.

        theme: "light" or "dark"; words: draw a caption; animate: move the balls
        """
        return self._engines().svg(is_dark(theme), words, animate)

    def _repr_svg_(self) -> Optional[str]:
        return None if self.status == "invalid" else self.svg()

    def plot(self, ax: Optional["Axes"] = None, shot: Optional[int] = None) -> "Axes":
        """Draws the table and the paths of all shots, or of one, with matplotlib, in metres."""
        from . import _plot

        scene = dict_of(self._puzzle)
        scene["ball"] = {key: value for key, value in scene["ball"].items() if key != "spin"}  # it may be a range
        axes = _plot.table(Trajectory({**scene, "shot": {"speed": 0, "angle": 0}}), ax)
        for i in range(len(self.shots)) if shot is None else [shot]:
            _plot.path(self.trajectory(i, to_target=True), axes, self.shots[i].in_words())
        return axes

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Answer) and (self._puzzle, self.json) == (other._puzzle, other.json)

    def __hash__(self) -> int:
        return hash(self.json)

    def __reduce__(self) -> Any:
        return Answer, (self._puzzle, self._flags, self.json)
