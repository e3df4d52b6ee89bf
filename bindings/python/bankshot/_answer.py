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
    """What `solve` found: shots, best first, and what it cost.

    It is the JSON of `bankshot solve --json` (`answer.json`), read when it is first looked at. In a notebook it draws
    itself; print(answer) tells it to a player.
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
        """Solved again where it came from a batch or a pickle: the same puzzle has the same answer."""
        if self._solved_by is None:
            self._solved_by = _engine.solve(self._puzzle, _engine.SolveFlags(**self._flags))
        return self._solved_by

    @property
    def json(self) -> str:
        """One line, to the byte as the program prints it."""
        if self._text is None:
            self._text = self._engines().json()
        return self._text

    def to_dict(self) -> Dict[str, Any]:
        """As docs/format.md has it; a new one each time."""
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
        """"solved", "no-shot", "budget", or of a batch's line that is no puzzle "invalid"."""
        return str(self._get("status"))

    @property
    def solved(self) -> bool:
        return self.status == "solved"

    @property
    def shots(self) -> List[Shot]:
        """Best first."""
        if self._shots is None:
            self._shots = [Shot.from_dict(shot) for shot in self._get("shots")]
        return self._shots

    @property
    def best(self) -> Optional[Shot]:
        """None where there is no shot."""
        return self.shots[0] if self.shots else None

    @property
    def nearest(self) -> Optional[Shot]:
        """The closest miss, where there is no shot."""
        miss = self._get("nearest")
        return Shot.from_dict(miss) if miss else None

    @property
    def message(self) -> str:
        """One sentence for a person."""
        return str(self._get("message"))

    @property
    def error(self) -> Optional[Dict[str, str]]:
        """What is wrong with the puzzle, of "invalid": its "path" and the "reason"."""
        error: Optional[Dict[str, str]] = self._get("error")
        return error

    @property
    def simulations(self) -> Optional[int]:
        """Spent, search and proof."""
        count: Optional[int] = self._get("simulations")
        return count

    @property
    def time_us(self) -> Optional[float]:
        """Microseconds of the search; None with no_timing."""
        time: Optional[float] = self._get("time_us")
        return time

    def trajectory(self, shot: int = 0, rate: float = 60, to_target: bool = False) -> Trajectory:
        """Plays one of the shots until all balls rest, or until the target is reached."""
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
        """The picture of `bankshot solve --svg`. theme: "light" or "dark"; words: a caption; animate: the balls roll."""
        return self._engines().svg(is_dark(theme), words, animate)

    def _repr_svg_(self) -> Optional[str]:
        return None if self.status == "invalid" else self.svg()

    def plot(self, ax: Optional["Axes"] = None, shot: Optional[int] = None) -> "Axes":
        """Draws the table and the paths of all shots, or of one, with matplotlib: metres."""
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
