"""Marks of the picture: nodes with their numbers, lumped masses, supports."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.view import View
from vmharness.report.figures.model.frame import Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import INK, MANY, MASS, NUMBERED, SUPPORT

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

LEAST = 9.0  # points: size of the mark of a mass


def draw_marks(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """Supports, masses and nodes; not all supports of many."""
    at, size = frame.at(view.x), mass_size(view, frame)
    supports = np.intersect1d(view.supports, view.rows)
    supports = supports[:: max(1, -(-supports.size // (2 * MANY)))]
    small = {"markersize": 6.0} if supports.size > MANY else {}
    axes.plot(*at[supports].T, zorder=4, **SUPPORT | small)
    axes.plot(*at[view.masses].T, zorder=4.2, **MASS | {"markersize": size})
    if view.rows.size <= MANY:
        axes.plot(*at[view.rows].T, linestyle="none", marker="o", markersize=3.4, color=INK, zorder=5)
    for row in supports:
        reach = 0.25 * (SUPPORT | small)["markersize"]  # half the height of the triangle
        labels.avoid_mark(at[row] - [0.0, reach], 1.2 * reach)
    for row in view.masses:
        labels.avoid_mark(at[row], 0.5 * size)


def number_nodes(view: View, frame: Frame, labels: Labels) -> None:
    """The numbers of the nodes, or of the masses alone if there are many; nodes at one place share a label."""
    rows = next((rows for rows in (view.rows, view.masses) if rows.size <= NUMBERED), view.rows[:0])
    at, size = frame.at(view.x), mass_size(view, frame)
    places: dict[tuple[float, ...], list[int]] = {}
    for row in rows.tolist():
        places.setdefault(tuple(np.round(at[row], 2).tolist()), []).append(row)
    for here in places.values():
        name = ", ".join(str(view.ids[row]) for row in here)
        radius = 0.5 * size if np.isin(here, view.masses).any() else 2.0
        labels.place(name, at[here[:1]], radius, color=INK, weight="bold")


def mass_size(view: View, frame: Frame) -> float:
    """Size of the marks of masses, in points: as large as the nearest two allow."""
    at = np.unique(np.round(frame.at(view.x[view.masses]), 2), axis=0)
    if not 1 < len(at) <= 10 * MANY:
        return float(MASS["markersize"])
    far = np.hypot(*(at[:, None] - at[None]).T)
    nearest = float(far[~np.eye(len(at), dtype=bool)].min())
    return float(np.clip(round(nearest, 1), LEAST, MASS["markersize"]))
