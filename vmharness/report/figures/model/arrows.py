"""Arrows: forces, pressures and motions at their places, and the directions of x, y and z."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.view import View
from vmharness.report.figures.model.frame import ISOMETRIC, Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import INITIAL, INK, LOAD, MANY, MASS, MOVE, QUIET
from vmharness.report.figures.note import MIDDLE, note
from vmharness.round_off import ROUND_OFF

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

LENGTH, SHORT = 26.0, 17.0  # points
HEAD = 6.0  # points, of an arrow
CORNER = (46.0, 16.0)  # of the directions of x, y and z
ASIDE = 8.0  # points from a line of nodes to the arrows of their velocity


@dataclass(frozen=True)
class Arrow:
    """An arrow at a place of the model; its ends are in points from there."""

    at: Array  # (3,)
    tail: Array  # (2,)
    head: Array  # (2,)
    colour: str = LOAD
    width: float = 1.6
    heads: int = 1  # two for a rotation


def arrows(view: View) -> Iterator[Arrow]:
    """Arrows of loads and motions, and of what moves at the start; not all of many."""
    for what, (places, directions) in view.arrows.items():
        stride = max(1, -(-len(places) // MANY))
        for at, direction in zip(places[::stride], directions[::stride], strict=True):
            if what in INITIAL:
                yield _initial(view, at, ISOMETRIC @ direction, INITIAL[what])
            else:
                yield _acting(view, what, at, ISOMETRIC @ direction, stride > 1)


def _acting(view: View, what: str, at: Array, along: Array, many: bool) -> Arrow:
    """The arrow of a load or motion: away from the model, or toward it where it acts inward."""
    flat = view.x[view.rows] @ ISOMETRIC.T
    clear = _clear(view, at) * unit(along)
    far = clear + (SHORT if many else LENGTH) * along
    inward = along @ (flat.mean(axis=0) - ISOMETRIC @ at) > ROUND_OFF * float(np.ptp(flat, axis=0).max())
    tail, head = (-far, -clear) if what == "pressure" or inward else (clear, far)
    return Arrow(at, tail, head, width=0.9 if many else 1.6)


def _initial(view: View, at: Array, along: Array, heads: int) -> Arrow:
    """The arrow of an initial velocity; in a model of many nodes beside its node, for it may lie along a bar."""
    clear, (across, up) = _clear(view, at), unit(along)
    beside = view.rows.size > MANY and not clear
    start = ASIDE * np.array([-up, across]) if beside else clear * np.array([across, up])
    return Arrow(at, start, start + LENGTH * along, MOVE, heads=heads)


def _clear(view: View, at: Array) -> float:
    """How far the mark of a mass or of a centre of mass reaches from its place, in points."""
    marked = [view.x[view.masses], *(body.centre[None] for body in view.bodies if body.centre is not None)]
    here = np.all(np.concatenate(marked) == at, axis=1)
    return 0.5 * float(MASS["markersize"]) + 1.0 if here.any() else 0.0


def draw_arrows(axes: "Axes", found: list[Arrow], frame: Frame, labels: Labels) -> None:
    """Draw the arrows, and keep labels away from them."""
    for arrow in found:
        tail, head = frame.at(arrow.at) + arrow.tail, frame.at(arrow.at) + arrow.head
        labels.avoid_line(np.array([tail, head]))
        draw_arrow(axes, tail, head, arrow.colour, arrow.width, arrow.heads)


def draw_directions(axes: "Axes") -> None:
    """The directions of x, y and z, in the lower left corner."""
    origin = np.array(CORNER)
    for name, direction in zip("xyz", ISOMETRIC.T, strict=True):
        draw_arrow(axes, origin, origin + SHORT * direction, QUIET, 1.0)
        beside = origin + (SHORT + 8.0) * direction + [0.0, 9 * MIDDLE]
        note(axes, name, beside, ha="center", style="italic", color=INK)


def draw_arrow(
    axes: "Axes", start: Array, end: Array, colour: str, width: float = 1.6, heads: int = 1
) -> None:
    """An arrow between two places on the canvas; a ring for one along the line of sight."""
    if np.hypot(*(end - start)) < HEAD:
        axes.plot(*end, marker="o", markersize=HEAD, mfc="none", mec=colour, mew=width, zorder=6.5)
        return
    shape = {"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0}
    for number in range(heads):
        tip = end - number * HEAD * unit(end - start)
        axes.annotate("", tuple(tip), tuple(start), arrowprops={**shape, "mutation_scale": 12}, zorder=6.5)


def unit(vector: Array) -> Array:
    """The vector (2,) with a length of one; zero for one along the line of sight, which has none in the picture."""
    length = float(np.hypot(*vector))
    return np.asarray(vector / length if length > ROUND_OFF else np.zeros(2))
