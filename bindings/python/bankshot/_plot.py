# SPDX-License-Identifier: MIT
"""Draws tables and paths with matplotlib, which is imported with this file."""
from __future__ import annotations

from typing import Optional

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon

from ._trajectory import Trajectory

_wood, _ink = "#7a4f2b", "#222222"


def table(scene: Trajectory, ax: Optional[Axes] = None) -> Axes:
    """Draws the cushion noses, the pockets, and the balls at their start positions."""
    axes = plt.gca() if ax is None else ax
    axes.add_patch(Polygon(scene._played.vertices(), closed=True, fill=False, edgecolor=_wood, linewidth=2))
    for _, x, y, half in scene._played.pockets():
        axes.add_patch(Circle((x, y), half, color=_ink, alpha=0.7))
    for name in scene.balls:
        first = scene.of(name)[0]
        axes.plot(first["x"], first["y"], "o", color=_ink, markersize=4)
        axes.annotate(name, (first["x"], first["y"]), textcoords="offset points", xytext=(4, 4))
    axes.set_aspect("equal")
    axes.set_xlabel("m")
    axes.set_ylabel("m")
    axes.autoscale_view()
    return axes


def path(trajectory: Trajectory, axes: Axes, label: Optional[str] = None) -> Axes:
    """Draws the paths of all balls that move."""
    for i, name in enumerate(trajectory.balls):
        rows = trajectory.of(name)
        if len(rows) > 1:
            axes.plot(rows["x"], rows["y"], label=(label or name) if i == 0 else f"_{name}")
    return axes
