# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, List, Optional

import numpy as np
import numpy.typing as npt

from . import _engine
from ._documents import Document, text_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Column = npt.NDArray[np.float64]


def is_dark(theme: str) -> bool:
    if theme not in ("light", "dark"):
        raise ValueError(f'theme must be "light" or "dark", and is "{theme}"')
    return theme == "dark"


class Trajectory:
    """A simulated shot: arrays of the cue ball, sampled `rate` times a second and at every event.

    t s; x, y m; vx, vy m/s; wx, wy, wz rad/s, z points up. `of("8")` returns those of another ball. A notebook shows
    the shot as a picture.
    """

    def __init__(self, scene: Document, rate: float = 60) -> None:
        self._scene, self._rate = text_of(scene), rate
        self._played = _engine.simulate(self._scene)
        self._rows: Optional[npt.NDArray[np.void]] = None
        self._document: Optional[Dict[str, Any]] = None

    @property
    def rows(self) -> npt.NDArray[np.void]:
        """Rows of all balls in order of time: t, ball (its index in `balls`), x, y, vx, vy, wx, wy, wz."""
        if self._rows is None:
            self._rows = self._played.rows(self._rate)
        return self._rows

    def of(self, ball: str) -> npt.NDArray[np.void]:
        """Returns the rows of one ball by its name; the cue ball is "cue"."""
        if ball not in self.balls:
            raise KeyError(f'no ball is called "{ball}": {", ".join(self.balls)}')
        return self._of(self.balls.index(ball))

    def _of(self, ball: int) -> npt.NDArray[np.void]:
        rows: npt.NDArray[np.void] = self.rows[self.rows["ball"] == ball]
        return rows

    def _column(self, name: str) -> Column:
        column: Column = self._of(0)[name]
        return column

    @property
    def t(self) -> Column:
        """Time since the launch [s]."""
        return self._column("t")

    @property
    def x(self) -> Column:
        """x of the ball's centre [m]."""
        return self._column("x")

    @property
    def y(self) -> Column:
        """y of the ball's centre [m]."""
        return self._column("y")

    @property
    def vx(self) -> Column:
        """m/s"""
        return self._column("vx")

    @property
    def vy(self) -> Column:
        """m/s"""
        return self._column("vy")

    @property
    def wx(self) -> Column:
        """rad/s"""
        return self._column("wx")

    @property
    def wy(self) -> Column:
        """rad/s"""
        return self._column("wy")

    @property
    def wz(self) -> Column:
        """rad/s, anticlockwise seen from above"""
        return self._column("wz")

    @property
    def balls(self) -> List[str]:
        """Names of the balls; the first is the cue ball."""
        return self._played.balls()

    def to_dict(self) -> Dict[str, Any]:
        """Returns the document of `bankshot simulate --json` as a new dict."""
        document: Dict[str, Any] = json.loads(self.json)
        return document

    def _get(self, key: str) -> Any:
        if self._document is None:
            self._document = self.to_dict()
        return self._document[key]

    @property
    def json(self) -> str:
        """One line of JSON, byte for byte as the program prints it."""
        return self._played.json()

    @property
    def events(self) -> List[Dict[str, Any]]:
        """Events in order: "type", "time" s, "ball", "at" m, "velocity" m/s, "spin" rad/s, and the contact."""
        events: List[Dict[str, Any]] = self._get("events")
        return events

    @property
    def end(self) -> Dict[str, Any]:
        """End of the cue ball's path: "reason", "time" s, "at" m, "cushions", "length" m."""
        end: Dict[str, Any] = self._get("end")
        return end

    def __repr__(self) -> str:
        end = self.end
        return (
            f"<Trajectory {end['reason']} after {end['time']:.3f} s, {end['length']:.3f} m and {end['cushions']}"
            f" cushions at ({end['at'][0]:.4f}, {end['at'][1]:.4f}) m>"
        )

    def svg(self, theme: str = "light", words: bool = True, animate: bool = False) -> str:
        """Returns the picture of `bankshot simulate --svg`. theme: "light" or "dark"; animate: moving balls."""
        return self._played.svg(is_dark(theme), words, animate)

    def _repr_svg_(self) -> str:
        return self.svg()

    def plot(self, ax: Optional["Axes"] = None) -> "Axes":
        """Draws the table and the paths of all balls with matplotlib, in metres."""
        from . import _plot

        return _plot.path(self, _plot.table(self, ax))

    def __reduce__(self) -> Any:
        return Trajectory, (self._scene, self._rate)
