"""Springs and dampers between two nodes, side by side where they join the same two."""

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.view import View
from vmharness.report.figures.model.arrows import unit
from vmharness.report.figures.model.frame import ISOMETRIC, Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import DISCRETE, SUPPORT

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

COIL, DASHPOT, HALF = 54.0, 20.0, 5.0  # points: length of a coil and of a dashpot, and half their width
GROUND = 46.0  # points from a node to the ground
SHARE = 0.4  # of the distance of the nodes: at most so much of it is coil or dashpot
APART = 17.0  # points between the axes of elements that join the same nodes
TEETH = 8


def draw_discrete(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """A zigzag for each spring, and a piston in a pot for each damper; the ground is a support."""
    pairs = [tuple(sorted(pair)) for pair in view.discrete.nodes.tolist()]
    count, seen = Counter(pairs), Counter[tuple[int, ...]]()
    for number, (first, second) in enumerate(view.discrete.nodes):
        start = frame.at(view.x[first])
        end = frame.at(view.x[second]) if second >= 0 else start + to_ground(view.discrete.direction[number])
        length = float(np.hypot(*(end - start)))
        if length == 0.0:
            continue
        aside = APART * (seen[pairs[number]] - 0.5 * (count[pairs[number]] - 1))
        seen[pairs[number]] += 1
        along = (end - start) / length
        turn = np.array([along, [-along[1], along[0]]])
        for line in _damper(length, aside) if view.discrete.damper[number] else _spring(length, aside):
            drawn = start + np.array(line) @ turn
            axes.plot(*drawn.T, zorder=2, **DISCRETE)
            labels.avoid_line(drawn)
        if second < 0:
            axes.plot(*end, zorder=4, **SUPPORT)


def to_ground(direction: Array) -> Array:
    """The way (2,) from a node to the ground in points, against the direction of a spring; downward without one."""
    along = unit(-ISOMETRIC @ direction)
    return np.asarray(GROUND * (along if along.any() else np.array([0.0, -1.0])))


def _spring(length: float, aside: float) -> list[list[tuple[float, float]]]:
    """The line of a spring: places along its axis and across it."""
    half = 0.5 * min(COIL, SHARE * length)
    pitch = 2.0 * half / TEETH
    first = 0.5 * length - half
    teeth = [
        (first + (number + 0.5) * pitch, aside + min(HALF, 1.2 * pitch) * (-1) ** number)
        for number in range(TEETH)
    ]
    return [_stubs(length, aside, [(first, aside), *teeth, (first + 2.0 * half, aside)])]


def _damper(length: float, aside: float) -> list[list[tuple[float, float]]]:
    """The lines of a damper: the rod with its piston, and the pot with its own rod."""
    half = 0.5 * min(DASHPOT, SHARE * length)
    wide = min(HALF, half)
    left, middle, right = 0.5 * length - half, 0.5 * length, 0.5 * length + half
    rod = _stubs(length, aside, [(middle, aside)])[:-2]
    pot = [(right, aside + side * wide) for side in (1.0, -1.0)]
    return [
        rod,
        [(middle, aside - 0.7 * wide), (middle, aside + 0.7 * wide)],
        [(left, aside + wide), *pot, (left, aside - wide)],
        _stubs(length, aside, [(right, aside)])[-3:],
    ]


def _stubs(length: float, aside: float, line: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The line continued to both nodes: beside the axis of the nodes, by way of two corners."""
    turn = 0.5 * (1.0 - SHARE) * length * 0.5
    return [(0.0, 0.0), (turn, aside), *line, (length - turn, aside), (length, 0.0)]
