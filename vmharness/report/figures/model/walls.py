"""Rigid walls."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.view import View
from vmharness.mesh.walls import Wall
from vmharness.report.figures.model.arrows import LENGTH, SHORT, draw_arrow
from vmharness.report.figures.model.frame import ISOMETRIC, VIEWER, Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import INK, MOVE, QUIET, WALL, WALL_EDGE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

PATCH = 0.15  # of the size of the model: half the edge of an infinite wall, at least


def patch(view: View, wall: Wall) -> Array:
    """The corners (4, 3) of a wall; of an infinite one, of a part before the nodes that it acts on."""
    if wall.edges is not None:
        first, second = wall.edges
        return wall.at + np.array([np.zeros(3), first, first + second, second])
    rows = np.intersect1d(wall.nodes, view.rows)
    x = view.x[rows if rows.size else view.rows]
    middle = 0.5 * (x.min(axis=0) + x.max(axis=0))
    foot = middle - ((middle - wall.at) @ wall.normal) * wall.normal
    size = float(np.ptp(np.array([*view.x[view.rows], foot]), axis=0).max()) or 1.0
    first = np.cross(wall.normal, np.eye(3)[np.argmax(np.abs(wall.normal)) - 1])
    first /= np.linalg.norm(first)
    edges = np.array([first, np.cross(wall.normal, first)])
    half = 0.5 * np.ptp(x @ edges.T, axis=0) + PATCH * size
    return foot + np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * half @ edges


def draw_walls(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """A patch of each wall, its normal, and its direction if it moves; a wall before the model lets it show through."""
    for wall in view.walls:
        corners = frame.at(patch(view, wall))
        behind = wall.normal @ VIEWER >= 0.0
        axes.fill(
            *corners.T, facecolor=WALL, edgecolor=WALL_EDGE, linewidth=1.0,
            alpha=1.0 if behind else 0.6, zorder=0.5 if behind else 2.5,
        )  # fmt: skip
        labels.avoid_line(np.concatenate([corners, corners[:1]]))
        top = corners[np.argmax(corners[:, 1])]
        foot, along = (
            0.5 * (top + corners.mean(axis=0)),
            ISOMETRIC @ wall.normal,
        )  # beside what lies at the middle
        draw_arrow(axes, foot, foot + SHORT * along, QUIET, 0.9)
        if wall.velocity:
            draw_arrow(axes, foot, foot + np.sign(wall.velocity) * LENGTH * along, MOVE, 1.6)
        moving = "moving " if wall.velocity is not None else ""
        name = f" ({wall.name})" if wall.name not in ("", "wall") else ""
        labels.place(f"{moving}wall {wall.number}{name}", corners, 2.0, color=INK)
