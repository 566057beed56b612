"""Colours, lines and marks of the picture of a model; the key shows the same."""

from typing import Any

import numpy as np
from matplotlib.path import Path

INK, QUIET, FACE, EDGE, LOAD = "#1b2733", "#5b6670", "#dbe7f3", "#4a6a8a", "#b45309"
RIGID, RIGID_EDGE, TOUCH, WALL, WALL_EDGE, MOVE = (
    "#d9d2c3",
    "#7a6f5a",
    "#7b3294",
    "#e9e6df",
    "#8d8674",
    "#0f766e",
)
TRIANGLE = ((0.0, 0.0), (-0.6, -1.0), (0.6, -1.0), (0.0, 0.0))  # under the node, its tip at the node
MANY = 30  # nodes: more marks, or lines of contact, would hide the model
NUMBERED = 16  # nodes: more numbers would lie on one another


def _centre_of_mass() -> Path:
    """A ring with two of its quarters filled."""
    ring = Path.unit_circle()
    inner = Path(0.84 * np.asarray(ring.vertices)[::-1], ring.codes)
    return Path.make_compound_path(ring, inner, Path.wedge(0, 90), Path.wedge(180, 270))


NO_LINE: dict[str, Any] = {"linestyle": "none"}
MASS: dict[str, Any] = {**NO_LINE, "marker": "o", "markersize": 15, "mfc": "#c9d3db", "mec": INK}
SHELL: dict[str, Any] = {**NO_LINE, "marker": "s", "markersize": 10, "mfc": FACE, "mec": EDGE}
BODY: dict[str, Any] = {**NO_LINE, "marker": "s", "markersize": 10, "mfc": RIGID, "mec": RIGID_EDGE}
PLANE: dict[str, Any] = {**NO_LINE, "marker": "D", "markersize": 8, "mfc": WALL, "mec": WALL_EDGE}
SUPPORT: dict[str, Any] = {**NO_LINE, "marker": TRIANGLE, "markersize": 13, "mfc": "white", "mec": "#3f7d20"}
JOINT: dict[str, Any] = {**NO_LINE, "marker": "o", "markersize": 8, "mfc": "white", "mec": INK, "mew": 1.4}
CENTRE: dict[str, Any] = {
    **NO_LINE, "marker": _centre_of_mass(), "markersize": 10, "mfc": INK, "mec": "none",
}  # fmt: skip
BEAM: dict[str, Any] = {"color": EDGE, "linewidth": 2.4}
LINK: dict[str, Any] = {"color": RIGID_EDGE, "linewidth": 2.4}
DISCRETE: dict[str, Any] = {"color": INK, "linewidth": 1.2}
# In the key: three teeth of a spring; the pot of a damper with its piston.
SPRING: dict[str, Any] = DISCRETE | {
    "marker": ((-1.0, 0.0), (-0.6, 0.5), (-0.2, -0.5), (0.2, 0.5), (0.6, -0.5), (1.0, 0.0)),
    "markersize": 14,
    "mfc": "white",
    "mec": INK,
}
DAMPER: dict[str, Any] = DISCRETE | {"marker": "s", "markersize": 7, "mfc": "white", "mec": INK, "mew": 1.2}
INITIAL = {"initial velocity": 1, "initial spin": 2}  # heads of arrows
CONTACT: dict[str, Any] = {"color": TOUCH, "linewidth": 1.2, "linestyle": (0, (4, 3))}
SEGMENT: dict[str, Any] = {"marker": "s", "markersize": 10, "mfc": "#e6d9ec", "mec": "none"}  # under the line
TOUCHING: dict[str, Any] = {**NO_LINE, "marker": "o", "markersize": 3.4, "color": TOUCH}
