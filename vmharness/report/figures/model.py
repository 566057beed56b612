"""The model as read from the deck, in isometric view."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.report.figures import svg
from vmharness.report.figures.characters import unit
from vmharness.result import View

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

INK, QUIET, SHELL, SUPPORT, LOAD, CONTACT = "#1b2733", "#5b6670", "#dbe7f3", "#3f7d20", "#b45309", "#7b3294"
TRIANGLE = ((0.0, 0.0), (-0.6, -1.0), (0.6, -1.0), (0.0, 0.0))  # under the node, its tip at the node
MANY = 60  # nodes: more numbers, or lines of contact, would hide the model
# Rows are the directions of the drawing, to the right and up: the axes 120 degrees apart, z upright.
ISOMETRIC = np.array([[np.sqrt(3.0) / 2.0, -np.sqrt(3.0) / 2.0, 0.0], [0.5, 0.5, 1.0]])


def draw(view: View, case: str, acceleration: str) -> str:
    """SVG of nodes with their numbers, shells, masses, supports, contact, and body load in the unit `acceleration`."""
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context(svg.STYLE):
        figure = Figure(figsize=(7.4, 3.9))
        axes = figure.add_axes((0.3, 0.03, 0.68, 0.94))
        axes.set_axis_off()
        axes.set_aspect("equal")
        at = view.x @ ISOMETRIC.T  # (n, 2)
        size = float(np.ptp(at, axis=0).max()) or 1.0
        _shells(axes, view, at)
        _contacts(axes, view, at)
        _nodes(axes, view, at)
        _body_load(axes, view, at, size, acceleration)
        _directions(axes, at, size)
        axes.margins(0.08)
        figure.legend(loc="center left", bbox_to_anchor=(0.04, 0.5), frameon=False, labelspacing=1.0)
        return svg.text(figure, f"{case}-model", "The model as read from the deck, in isometric view")


def _shells(axes: "Axes", view: View, at: Array) -> None:
    from matplotlib.collections import PolyCollection

    if view.shells.size:
        axes.add_collection(
            PolyCollection(
                [at[shell] for shell in view.shells],
                facecolors=SHELL,
                edgecolors="#4a6a8a",
                linewidths=0.4 if view.shells.shape[0] > MANY else 1.2,
                label=_counted(view.shells.shape[0], "shell element"),
            )
        )


def _contacts(axes: "Axes", view: View, at: Array) -> None:
    """A dashed line from each tracked node to the middle of the nearest segment that it may touch."""
    for tracked, segments in view.contacts:
        if not segments.size or not 0 < tracked.size <= MANY:
            continue
        label = f"contact: {_counted(tracked.size, 'node')}\non {_counted(segments.shape[0], 'segment')}"
        middle = view.x[segments].mean(axis=1)
        for node in tracked:
            nearest = int(np.argmin(np.linalg.norm(middle - view.x[node], axis=1)))
            line = np.array([at[node], ISOMETRIC @ middle[nearest]])
            axes.plot(*line.T, color=CONTACT, linewidth=1.2, linestyle=(0, (4, 3)), zorder=2, label=label)
            label = ""  # one entry in the legend is enough


def _nodes(axes: "Axes", view: View, at: Array) -> None:
    few = view.ids.size <= MANY
    _marks(axes, at[view.supports], "supported node", marker=TRIANGLE, markersize=13, markerfacecolor="white",
           markeredgecolor=SUPPORT, markeredgewidth=1.3)  # fmt: skip
    _marks(axes, at[view.masses], "mass element", marker="o", markersize=17, markerfacecolor="#c9d3db",
           markeredgecolor=INK, markeredgewidth=1.2)  # fmt: skip
    axes.plot(*at.T, linestyle="none", marker="o", markersize=3.4 if few else 1.2, color=INK, zorder=5)
    if few:
        middle = at[:, 0].mean()
        for row, (number, place) in enumerate(zip(view.ids, at, strict=True)):
            side = 1 if place[0] >= middle - 1e-9 else -1
            axes.annotate(
                str(number),
                place,
                (side * (14 if row in view.masses else 9), 2),
                textcoords="offset points",
                ha="left" if side > 0 else "right",
                va="center",
                color=INK,
                weight="bold",
            )


def _marks(axes: "Axes", at: Array, what: str, **style: object) -> None:
    if at.size:
        axes.plot(*at.T, linestyle="none", zorder=4, label=_counted(at.shape[0], what), **style)


def _body_load(axes: "Axes", view: View, at: Array, size: float, acceleration: str) -> None:
    """An arrow the way that the body load pulls, beside the first mass or the middle of the model."""
    if not np.any(view.gravity):
        return
    start = (at[view.masses[0]] if view.masses.size else at.mean(axis=0)) + [0.17 * size, 0.0]
    end = start + 0.3 * size * (ISOMETRIC @ view.gravity) / np.linalg.norm(view.gravity)
    _arrow(axes, start, end, LOAD, 1.6)
    pulls = ", ".join(f"{axis}: {value:+.6g} {unit(acceleration)}" for axis, value in zip("xyz", view.gravity) if value)
    axes.annotate(f"body load\n{pulls.replace('-', '−')}", (start + end) / 2, (8, 0), textcoords="offset points",
                  va="center", color=LOAD, linespacing=1.4)  # fmt: skip


def _directions(axes: "Axes", at: Array, size: float) -> None:
    """The directions of x, y and z, beside the model."""
    origin = np.array([at[:, 0].max() + 0.5 * size, at[:, 1].min()])
    for name, direction in zip("xyz", ISOMETRIC.T, strict=True):
        end = origin + 0.12 * size * direction
        _arrow(axes, origin, end, QUIET, 1.0)
        axes.annotate(name, end, 7 * direction, textcoords="offset points", ha="center", va="center", style="italic")
    axes.update_datalim([origin, origin + 0.25 * size])


def _arrow(axes: "Axes", start: Array, end: Array, colour: str, width: float) -> None:
    shape = {"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", end, start, arrowprops={**shape, "mutation_scale": 12})
    axes.update_datalim([start, end])


def _counted(count: int, what: str) -> str:
    return f"{count} {what}" if count == 1 else f"{count} {what}s"
