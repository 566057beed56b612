"""Springs and dampers between two nodes, side by side where they join the same two."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.view import View
from vmharness.report.figures.model.frame import Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import DISCRETE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

COIL, DASHPOT, HALF = 54.0, 20.0, 5.0  # points: length of a coil and of a dashpot, and half their width
SHARE = 0.4  # of the distance of the nodes: at most so much of it is coil or dashpot
APART = 17.0  # points between the axes of elements that join the same nodes
TEETH = 8


def draw_discrete(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """A zigzag for each spring, and a piston in a pot for each damper."""
    at = frame.at(view.x[view.discrete])
    pairs = [tuple(sorted(pair)) for pair in view.discrete.tolist()]
    for number, (start, end) in enumerate(at):
        length = float(np.hypot(*(end - start)))
        if length == 0.0:
            continue
        place, among = pairs[:number].count(pairs[number]), pairs.count(pairs[number])
        aside = APART * (place - 0.5 * (among - 1))
        lines = _damper(length, aside) if view.dampers[number : number + 1].any() else _spring(length, aside)
        along = (end - start) / length
        turn = np.array([along, [-along[1], along[0]]])
        for line in lines:
            drawn = start + np.array(line) @ turn
            axes.plot(*drawn.T, zorder=2, **DISCRETE)
            labels.avoid_line(drawn)


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
