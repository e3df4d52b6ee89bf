# SPDX-License-Identifier: MIT
"""Puzzles and scenes as JSON, dicts or classes. docs/format.md lists every key with its unit and default."""
from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple, Type, TypeVar, Union

Named = Union[str, Mapping[str, Any]]
"""A name, such as "pool-9ft" or "spin", or an object with its own keys."""
Range = Union[float, Tuple[float, float], Sequence[float]]
"""One number, or the lowest and the highest number."""
_T = TypeVar("_T", bound="_Document")


class _Document:
    """A document whose fields are keys; fields that are None are left out."""

    def to_dict(self) -> Dict[str, Any]:
        fields = dataclasses.fields(self)
        return {f.name: getattr(self, f.name) for f in fields if getattr(self, f.name) is not None}

    @classmethod
    def from_dict(cls: Type[_T], document: Mapping[str, Any]) -> _T:
        return cls(**document)

    def __repr__(self) -> str:
        """Returns the class with the fields that are set."""
        return f"{type(self).__name__}({', '.join(f'{key}={value!r}' for key, value in self.to_dict().items())})"


@dataclass(repr=False)
class Puzzle(_Document):
    """A puzzle: the input of `solve`. None means the default of docs/format.md.

    Lengths are in metres, or in `unit`, from the lower left corner of the cloth, speeds in m/s, angles in degrees
    anticlockwise from +x. Puzzle("pool-9ft", {"at": [0.635, 0.40]}, {"pocket": "top-right"}, cushions=1)
    """

    table: Named
    ball: Mapping[str, Any]
    target: Mapping[str, Any]
    physics: Optional[Named] = None
    others: Optional[Sequence[Mapping[str, Any]]] = None
    settle: Optional[bool] = None
    unit: Optional[str] = None
    cushions: Union[None, int, Sequence[str], Mapping[str, int]] = None
    arrive: Optional[Mapping[str, Any]] = None
    speed: Optional[Range] = None
    angle: Optional[Sequence[float]] = None
    prefer: Optional[Named] = None
    leave: Optional[Mapping[str, Any]] = None
    aim: Optional[str] = None
    noise: Union[None, str, Mapping[str, Any]] = None
    budget: Optional[Mapping[str, int]] = None
    id: Union[None, str, int, float] = None
    about: Any = None


@dataclass(repr=False)
class Scene(_Document):
    """A table with its balls and a launch: the input of `simulate`. None means the default of docs/format.md.

    shot:  {"speed": m/s, "angle": degrees, "spin": {"top", "side", "masse"} in units of natural roll}, or a Shot
    until: where to stop: {"time": s, "cushions": bounces, "length": m}
    """

    table: Named
    ball: Mapping[str, Any]
    shot: Union[None, Mapping[str, Any], "Shot"] = None
    physics: Optional[Named] = None
    others: Optional[Sequence[Mapping[str, Any]]] = None
    settle: Optional[bool] = None
    unit: Optional[str] = None
    until: Optional[Mapping[str, float]] = None
    id: Union[None, str, int, float] = None


@dataclass(frozen=True, repr=False)
class Shot(_Document):
    """One shot of an answer, with its evidence. docs/format.md describes each key."""

    speed: float  # m/s; of the launch
    angle: float  # degrees, anticlockwise from +x
    spin: Dict[str, float]  # "top", "side", "masse": units of natural roll
    tip: Dict[str, float]  # m; "right" and "up" from the ball's centre
    cushions: Sequence[str]  # bounces in order
    miss: float  # m; miss of the replay
    arrival: Dict[str, Any]  # "time" s, "speed" m/s, "at" m
    condition: float  # m of arrival per radian of aim
    planner: str
    simulations: int
    pocket: Optional[str] = None
    offset: Optional[float] = None  # m; from the pocket's centre
    hits: Optional[Sequence[Dict[str, Any]]] = None
    then: Optional[Dict[str, Any]] = None
    scratch: Optional[bool] = None
    cue_rests: Union[None, str, Sequence[float]] = None  # m; or the pocket that the cue ball falls into
    leave: Optional[Dict[str, Any]] = None  # "at" m, "miss" m, "success", "cushions", "spread" m, "next"
    safety: Optional[bool] = None
    contact: Optional[Dict[str, Any]] = None  # "fullness", and "ghost" m: the first contact with a ball
    rattles: Optional[bool] = None
    off_centre: Optional[bool] = None
    aim: Optional[str] = None  # "safest" if the shot was moved off its exact root
    digits: Optional[int] = None
    margin: Optional[Dict[str, Any]] = None  # "angle" degrees, "speed" m/s: [down, up]
    success: Optional[float] = None  # probability that it is made
    value: Optional[float] = None  # success minus small costs of contacts, speed and tip offset
    sensitivity: Optional[Dict[str, float]] = None  # m per unit
    path: Optional[Sequence[Sequence[float]]] = None  # [s, m, m]
    paths: Optional[Dict[str, Any]] = None
    why: Optional[str] = None  # failure reason of a miss

    def __repr__(self) -> str:
        return f"<Shot {self.in_words()}>"

    def in_words(self) -> str:
        by = f" by {', '.join(self.cushions)}" if self.cushions else ""
        into = f" into {self.pocket}" if self.pocket else ""
        chance = "" if self.success is None else f", {100 * self.success:.0f} %"
        return f"{self.angle:.2f} degrees at {self.speed:.2f} m/s{by}{into}{chance}"


Document = Union[str, bytes, Mapping[str, Any], Puzzle, Scene]
"""JSON as text, a dict, or one of the classes."""


def _plain(value: Any) -> Any:
    """Converts numpy values, and our classes inside a dict, to plain values."""
    for how in ("to_dict", "tolist"):
        if hasattr(value, how):
            return getattr(value, how)()
    raise TypeError(f"{type(value).__name__} is nothing that JSON can hold")


def text_of(document: Document) -> str:
    """Returns the JSON of a document; numbers in a text are unchanged."""
    if isinstance(document, str):
        return document
    if isinstance(document, bytes):
        return document.decode()
    return json.dumps(document, default=_plain)


def dict_of(document: Document) -> Dict[str, Any]:
    """Returns the document as a new dict; a text must be valid JSON."""
    return dict(json.loads(text_of(document)))
