# SPDX-License-Identifier: MIT
from typing import Callable, List, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

version: str
learns: bool

class SolveFlags:
    def __init__(
        self,
        *,
        planner: str = ...,
        all: bool = ...,
        first: bool = ...,
        budget: int = ...,
        no_timing: bool = ...,
        no_robustness: bool = ...,
        sensitivity: bool = ...,
        path: bool = ...,
        noise: str = ...,
        depth: int = ...,
        plies: int = ...,
    ) -> None: ...

class Solved:
    def json(self) -> str: ...
    def text(self) -> str: ...
    def svg(self, dark: bool, words: bool, moving: bool) -> str: ...

class Played:
    def json(self) -> str: ...
    def svg(self, dark: bool, words: bool, moving: bool) -> str: ...
    def rows(self, rate: float) -> npt.NDArray[np.void]: ...
    def balls(self) -> List[str]: ...
    def vertices(self) -> npt.NDArray[np.float64]: ...
    def pockets(self) -> List[Tuple[str, float, float, float]]: ...

def solve(text: str, flags: SolveFlags) -> Solved: ...
def solve_lines(
    lines: List[str], flags: SolveFlags, threads: int, tell: Optional[Callable[[int], None]]
) -> List[str]: ...
def simulate(text: str) -> Played: ...
def simulate_many(
    text: str,
    speeds: npt.NDArray[np.float64],
    angles: npt.NDArray[np.float64],
    spins: Optional[npt.NDArray[np.float64]],
    threads: int,
) -> npt.NDArray[np.void]: ...
def map(text: str, columns: int, rows: int, flags: SolveFlags, value: bool) -> str: ...
def verify(puzzle: str, answer: str) -> str: ...
def generate(
    count: int,
    threads: int,
    *,
    seed: int,
    table: str,
    physics: str,
    cushions: str,
    target: str,
    balls: int,
    then: str,
    difficulty: str,
    unique: bool,
    no_spin: bool,
    speed: List[float],
) -> List[str]: ...
def fit(
    lines: List[str],
    *,
    free: List[str],
    model: str,
    restitution: int,
    rolling: int,
    holdout: int,
    predict: bool,
    threads: int,
) -> str: ...
def schema(document: str) -> str: ...
def tables() -> str: ...
