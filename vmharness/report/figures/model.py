"""The model as read from the deck, in isometric view."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.view import View
from vmharness.report.figures import svg
from vmharness.report.figures.characters import unit
from vmharness.report.figures.faces import far_first, outer
from vmharness.report.figures.key import Entry, key
from vmharness.report.figures.note import MIDDLE, note
from vmharness.round_off import ROUND_OFF, smallest

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

INK, QUIET, FACE, EDGE, LOAD = "#1b2733", "#5b6670", "#dbe7f3", "#4a6a8a", "#b45309"
TRIANGLE = ((0.0, 0.0), (-0.6, -1.0), (0.6, -1.0), (0.0, 0.0))  # under the node, its tip at the node
NO_LINE: dict[str, Any] = {"linestyle": "none"}
MASS: dict[str, Any] = {**NO_LINE, "marker": "o", "markersize": 15, "mfc": "#c9d3db", "mec": INK}
SHELL: dict[str, Any] = {**NO_LINE, "marker": "s", "markersize": 10, "mfc": FACE, "mec": EDGE}
SUPPORT: dict[str, Any] = {**NO_LINE, "marker": TRIANGLE, "markersize": 13, "mfc": "white", "mec": "#3f7d20"}
BEAM: dict[str, Any] = {"color": EDGE, "linewidth": 2.4}
DISCRETE: dict[str, Any] = {"color": INK, "linewidth": 1.2}
ARROW: dict[str, Any] = {"color": LOAD, "linewidth": 1.6}
CONTACT: dict[str, Any] = {"color": "#7b3294", "linewidth": 1.2, "linestyle": (0, (4, 3))}
MANY = 30  # nodes: more marks, or lines of contact, would hide the model
NUMBERED = 16  # nodes: more numbers would lie on one another
# Rows are the directions of the drawing, to the right and up: the axes 120 degrees apart, z upright.
ISOMETRIC = np.array([[np.sqrt(3.0) / 2.0, -np.sqrt(3.0) / 2.0, 0.0], [0.5, 0.5, 1.0]])

VIEWER = np.cross(*ISOMETRIC)  # toward the eye


def draw(view: View, case: str, acceleration: str) -> str:
    """SVG of nodes with their numbers, elements, supports, contact, loads, and body load in the unit `acceleration`."""
    from matplotlib.figure import Figure

    with svg.style(f"{case}-model"):
        figure = Figure(figsize=(6.6, 3.6))
        axes = figure.add_axes((0.3, 0.03, 0.68, 0.94))
        axes.set_axis_off()
        axes.set_aspect("equal")
        at = view.x @ ISOMETRIC.T  # (n, 2)
        size = float(np.ptp(at, axis=0).max()) or 1.0
        _faces(axes, far_first(outer(view.solids), view.x, VIEWER), at)
        _faces(axes, view.shells, at)
        _beams(axes, view, at)
        _discrete(axes, view, at)
        _contacts(axes, view, at)
        _nodes(axes, view, at)
        _arrows(axes, view, at, size)
        _body_load(axes, view, at, size, acceleration)
        _directions(axes, at, size)
        axes.margins(0.08)
        key(figure, _entries(view), start=(24.0, 170.0), step=(0.0, -26.0))
        return svg.text(figure, "The model as read from the deck, in isometric view")


def _entries(view: View) -> list[Entry]:
    """The key: each kind of entity, and its number."""
    tracked = sum(nodes.size for nodes, _ in view.contacts)
    segments = sum(segments.shape[0] for _, segments in view.contacts)
    entries = [
        (view.masses.size, _counted(view.masses.size, "mass element"), MASS),
        (view.shells.shape[0], _counted(view.shells.shape[0], "shell element"), SHELL),
        (len(view.solids), _counted(len(view.solids), "solid element"), SHELL),
        (len(view.beams), _counted(len(view.beams), "beam element"), BEAM),
        (len(view.discrete), _counted(len(view.discrete), "discrete element"), DISCRETE),
        (view.supports.size, _counted(view.supports.size, "supported node"), SUPPORT),
        (tracked, f"contact: {_counted(tracked, 'node')}\non {_counted(segments, 'segment')}", CONTACT),
        *(
            (len(at), f"{what} at {_counted(len(at), 'place')}", ARROW)
            for what, (at, _) in view.arrows.items()
        ),
    ]
    return [(label, style) for count, label, style in entries if count]


def _faces(axes: "Axes", faces: NDArray[np.intp], at: Array) -> None:
    from matplotlib.collections import PolyCollection

    if faces.size:
        width = 0.4 if len(faces) > MANY else 1.2
        corners = [at[face] for face in faces]
        axes.add_collection(PolyCollection(corners, facecolors=FACE, edgecolors=EDGE, linewidths=width))


def _beams(axes: "Axes", view: View, at: Array) -> None:
    from matplotlib.collections import LineCollection

    if view.beams.size:
        axes.add_collection(
            LineCollection(
                [at[beam] for beam in view.beams],
                zorder=1,
                colors=BEAM["color"],
                linewidths=BEAM["linewidth"],
            )
        )


def _discrete(axes: "Axes", view: View, at: Array) -> None:
    """A zigzag between the nodes of each spring or damper."""
    for a, b in view.discrete:
        across = 0.03 * np.array([at[a, 1] - at[b, 1], at[b, 0] - at[a, 0]])
        along = np.array([0.0, 0.3, *np.arange(0.325, 0.7, 0.05), 0.7, 1.0])
        side = np.array([0.0, 0.0, *np.resize([1.0, -1.0], along.size - 4), 0.0, 0.0])
        line = at[a] + np.outer(along, at[b] - at[a]) + np.outer(side, across)
        axes.plot(line[:, 0], line[:, 1], zorder=1, **DISCRETE)


def _contacts(axes: "Axes", view: View, at: Array) -> None:
    """A dashed line from each tracked node to the middle of the nearest segment that it may touch."""
    for tracked, segments in view.contacts:
        if not segments.size or tracked.size > MANY:
            continue
        middle = view.x[segments].mean(axis=1)
        for node in tracked:
            far = np.linalg.norm(middle - view.x[node], axis=1).tolist()
            nearest = smallest(range(len(far)), far.__getitem__)
            line = np.array([at[node], ISOMETRIC @ middle[nearest]])
            axes.plot(*line.T, zorder=2, **CONTACT)


def _nodes(axes: "Axes", view: View, at: Array) -> None:
    supports = view.supports[:: _stride(view.supports.size, 2 * MANY)]
    axes.plot(*at[supports].T, zorder=4, **SUPPORT | ({"markersize": 6} if supports.size > MANY else {}))
    axes.plot(*at[view.masses].T, zorder=4, **MASS)
    if view.ids.size <= MANY:
        axes.plot(*at.T, linestyle="none", marker="o", markersize=3.4, color=INK, zorder=5)
    if view.ids.size <= NUMBERED:
        _numbers(axes, view, at)


def _numbers(axes: "Axes", view: View, at: Array) -> None:
    """The numbers of the nodes; nodes at one position share a note."""
    middle = at[:, 0].mean()
    acted = {tuple(np.round(ISOMETRIC @ place, 9)) for where, _ in view.arrows.values() for place in where}
    places, group = np.unique(np.round(at, 9), axis=0, return_inverse=True)
    for number, place in enumerate(places):
        rows = np.flatnonzero(group.ravel() == number)
        side = 1 if place[0] >= middle - 1e-9 else -1
        below = 11.0 if tuple(place) in acted else -2.0
        offset = (side * (14 if np.isin(rows, view.masses).any() else 9), 9 * MIDDLE - below)
        name = ", ".join(str(view.ids[row]) for row in rows)
        note(axes, name, place, offset, ha="left" if side > 0 else "right", color=INK, weight="bold")


def _arrows(axes: "Axes", view: View, at: Array, size: float) -> None:
    """Arrows of forces and motions, which start at their node or, as pressure, end there; not all of many."""
    middle = at.mean(axis=0)
    for what, (places, directions) in view.arrows.items():
        stride = _stride(len(places), MANY)
        for place, direction in zip(places[::stride], directions[::stride], strict=True):
            start, reach = ISOMETRIC @ place, 0.13 * size * (ISOMETRIC @ direction)
            if what == "pressure" or reach @ (middle - start) > ROUND_OFF * size**2:
                start = start - reach
            _arrow(axes, start, start + reach, LOAD, 1.6 if stride == 1 else 0.9)


def _body_load(axes: "Axes", view: View, at: Array, size: float, acceleration: str) -> None:
    """An arrow in the direction of the body load, beside the first mass or the middle of the model."""
    if not np.any(view.gravity):
        return
    start = (at[view.masses[0]] if view.masses.size else at.mean(axis=0)) + [0.17 * size, 0.0]
    end = start + 0.3 * size * (ISOMETRIC @ view.gravity) / np.linalg.norm(view.gravity)
    _arrow(axes, start, end, LOAD, 1.6)
    pulls = ", ".join(
        f"{axis}: {value:+.6g} {unit(acceleration)}"
        for axis, value in zip("xyz", view.gravity, strict=True)
        if value
    )
    note(axes, f"body load\n{pulls.replace('-', '−')}", (start + end) / 2, (8, -9), color=LOAD)


def _directions(axes: "Axes", at: Array, size: float) -> None:
    """The directions of x, y and z, beside the model."""
    origin = np.array([at[:, 0].max() + 0.5 * size, at[:, 1].min()])
    for name, direction in zip("xyz", ISOMETRIC.T, strict=True):
        end = origin + 0.12 * size * direction
        _arrow(axes, origin, end, QUIET, 1.0)
        beside = 8 * direction
        note(axes, name, end, (beside[0], beside[1] + 9 * MIDDLE), ha="center", style="italic", color=INK)
    axes.update_datalim([origin, origin + 0.25 * size])


def _arrow(axes: "Axes", start: Array, end: Array, colour: str, width: float) -> None:
    shape = {"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", tuple(end), tuple(start), arrowprops={**shape, "mutation_scale": 12})
    axes.update_datalim([start, end])


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"


def _stride(count: int, most: int) -> int:
    """Stride with which at most `most` of them are drawn."""
    return max(1, -(-count // most))
