# SPDX-License-Identifier: MIT
"""What a user may write, and mypy must accept; also run."""
from typing import List, Optional

import numpy as np

import bankshot

puzzle = bankshot.Puzzle("pool-9ft", {"at": [0.635, 0.40]}, {"pocket": "bottom-middle"}, cushions=["top", "right"])
answer: bankshot.Answer = bankshot.solve(puzzle, sensitivity=True)
best: Optional[bankshot.Shot] = answer.best
if best is not None:
    scene = bankshot.Scene("pool-9ft", puzzle.ball, best)
    path = bankshot.simulate(scene)
    length: float = float(np.hypot(np.diff(path.x), np.diff(path.y)).sum())
    angles: List[float] = [best.angle - 0.1, best.angle, best.angle + 0.1]
    ends = bankshot.simulate_many(scene, best.speed, angles)
    made: int = int((ends["kind"] == bankshot.End.POCKETED).sum())
    print(f"{length:.2f} m, {made} of {len(angles)} fall")
try:
    bankshot.solve({"table": "pool-9ft"})
except bankshot.InvalidInput as e:
    reason: str = e.reason
    print(e.path, reason)
