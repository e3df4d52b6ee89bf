# SPDX-License-Identifier: MIT
"""Pool as a Gymnasium environment: one stroke per step, until all balls are down. Agents can learn from it; `hint`
returns the planner's stroke. Without Gymnasium, the class has the same methods but no spaces.

    python3 examples/pool_environment.py     lets the planner play two racks of three balls
"""
from __future__ import annotations

import numpy as np

import bankshot

try:
    import gymnasium
except ImportError:
    gymnasium = None

table, length, width, radius = "pool-9ft", 2.54, 1.27, 0.028575


class PoolEnvironment(gymnasium.Env if gymnasium else object):
    """Observation: x, y of each ball in m, the cue ball first; -1 for a ball that is down.
    Action: speed in m/s and angle in degrees. Reward: 1 for each ball that falls, -1 if the cue ball falls."""

    metadata = {"render_modes": ["svg"]}

    def __init__(self, balls: int = 3, most_strokes: int = 20, render_mode: str | None = None) -> None:
        self.balls, self.most_strokes, self.render_mode = balls, most_strokes, render_mode
        if gymnasium:
            box = gymnasium.spaces.Box
            self.observation_space = box(-1, np.array([[length, width]] * (balls + 1)), dtype=np.float64)
            self.action_space = box(np.array([0.1, 0.0]), np.array([8.0, 360.0]), dtype=np.float64)

    def reset(self, *, seed: int | None = None, options: dict | None = None) -> tuple[np.ndarray, dict]:
        if gymnasium:
            super().reset(seed=seed)
        random = np.random.default_rng(seed)
        self.at = np.empty((0, 2))
        while len(self.at) <= self.balls:
            drawn = random.uniform([0.2, 0.2], [length - 0.2, width - 0.2])
            if all(np.linalg.norm(self.at - drawn, axis=1) > 4 * radius):
                self.at = np.vstack([self.at, drawn])
        self.strokes, self.path = 0, None
        return self.at.copy(), {}

    def scene(self) -> dict:
        others = [{"id": str(i), "at": list(at)} for i, at in enumerate(self.at) if i > 0 and at[0] >= 0]
        return {"table": table, "ball": {"at": list(self.at[0])}, "others": others}

    def step(self, action) -> tuple[np.ndarray, float, bool, bool, dict]:
        speed, angle = float(action[0]), float(action[1])
        self.path = bankshot.simulate({**self.scene(), "shot": {"speed": speed, "angle": angle}})
        fell = {event["ball"] for event in self.path.events if event["type"] == "pocket"}
        for event in self.path.events:
            if event["type"] == "end":
                self.at[0 if event["ball"] == "cue" else int(event["ball"])] = event["at"]
        scratch = "cue" in fell
        for name in fell - {"cue"}:
            self.at[int(name)] = -1
        self.strokes += 1
        done = scratch or bool((self.at[1:, 0] < 0).all())
        return self.at.copy(), len(fell) - 2.0 * scratch, done, self.strokes >= self.most_strokes, {"fell": sorted(fell)}

    def render(self) -> str | None:
        return self.path.svg() if self.path else None

    def hint(self) -> np.ndarray | None:
        """Returns the planner's stroke: the most successful pot, straight or by a cushion."""
        target = {"ball": "any", "then": {"pocket": "any", "cushions": {"max": 1}}}
        best = bankshot.solve({**self.scene(), "target": target, "cushions": {"max": 1}}).best
        return None if best is None else np.array([best.speed, best.angle])


if __name__ == "__main__":
    environment = PoolEnvironment()
    for seed in (1, 2):
        environment.reset(seed=seed)
        total, over = 0.0, False
        while not over:
            stroke = environment.hint()
            if stroke is None:
                break
            _, reward, down, late, _ = environment.step(stroke)
            total, over = total + reward, down or late
        print(f"rack {seed}: {total:.0f} points in {environment.strokes} strokes")
