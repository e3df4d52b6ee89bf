# SPDX-License-Identifier: MIT
"""Finds where to aim and how hard, so that a ball reaches a pocket or a point after the cushions you ask for.

>>> import bankshot
>>> answer = bankshot.solve({"table": "pool-9ft", "ball": {"at": [0.635, 0.40]},
...                          "target": {"pocket": "bottom-middle"}, "cushions": ["top", "right"]})
>>> answer.best.angle, answer.best.speed   # degrees, m/s
>>> print(answer)

Documents have the program's format (docs/format.md): metres from the lower left corner of the cloth, m/s, degrees
anticlockwise from +x. docs/python.md shows more.
"""
from ._answer import Answer
from ._calls import (
    End,
    fit,
    generate,
    map,
    play,
    schema,
    simulate,
    simulate_many,
    solve,
    solve_all,
    solve_batch,
    tables,
    verify,
)
from ._documents import Document, Puzzle, Scene, Shot
from ._engine import version as __version__
from ._errors import InvalidInput
from ._trajectory import Trajectory

__all__ = [
    "Answer",
    "Document",
    "End",
    "InvalidInput",
    "Puzzle",
    "Scene",
    "Shot",
    "Trajectory",
    "fit",
    "generate",
    "map",
    "play",
    "schema",
    "simulate",
    "simulate_many",
    "solve",
    "solve_all",
    "solve_batch",
    "tables",
    "verify",
]
