"""Labels that lie neither on each other nor on marks, and on as few lines as possible."""

from collections.abc import Iterable
from itertools import pairwise, product
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from vmharness.report.figures.model.frame import Box
from vmharness.report.figures.note import note, width

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

SIZE = 9.0  # of the letters
ABOVE, BELOW = 0.76, 0.24  # of a line of text: height over the baseline and depth, in sizes of the letters
SPACING = 4.0  # points between the samples of a line
GAPS = (3.0, 7.0, 12.0, 18.0, 28.0, 40.0, 56.0)  # points from a mark to its label, the nearest first
LED = 8.0  # a label farther than this has a line to its mark
# Where a label may stand about its mark: right, left, above, below, then between them.
SIDES = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1))
ON_MARK, ON_LINE, FARTHER = (
    12.0,
    4.0,
    1.5,
)  # what is bad about a place: a mark, a sample of a line, a point of gap
LONGEST = 32  # letters
CLEAR = 1.5  # points about a label


class Labels:
    """The labels of a drawing, each placed where it disturbs least of what is there already."""

    def __init__(self, axes: "Axes", room: Box) -> None:
        self.axes, self.room = axes, room
        self.texts: list[Box] = []
        self.marks: list[Box] = []
        self.samples: list[Array] = []

    def avoid_mark(self, at: Array, radius: float) -> None:
        """Keep labels away from a mark of this radius."""
        self.marks.append(Box(at[0] - radius, at[1] - radius, at[0] + radius, at[1] + radius))

    def avoid_line(self, line: Array) -> None:
        """Keep labels away from the points (n, 2) of a line, where there is a better place."""
        for start, end in pairwise(line):
            count = int(np.hypot(*(end - start)) / SPACING) + 2
            self.samples.append(start + np.linspace(0.0, 1.0, count)[:, None] * (end - start))

    def avoid_points(self, points: Array) -> None:
        """Keep labels away from points (n, 2), where there is a better place."""
        self.samples.append(points)

    def place(self, text: str, places: Array, radius: float, **style: Any) -> None:
        """Write a label beside a mark at one of `places` (n, 2); where there is no room for it, it is left out."""
        text = text if len(text) <= LONGEST else f"{text[: LONGEST - 1].rstrip()}…"
        points = np.concatenate([np.zeros((0, 2)), *self.samples])
        wide = width(text, SIZE, bold="weight" in style)
        best: tuple[float, Box, Array] | None = None
        for at, gap in product(places, GAPS):
            for box in _boxes(at, radius + gap, wide):
                if box.inside(self.room) and not any(map(box.meets, self.texts)):
                    bad = FARTHER * (gap - GAPS[0]) + self._disturbed(box, points)
                    if best is None or bad < best[0]:
                        best = (bad, box, at)
        if best is not None:
            _, box, at = best
            self.texts.append(box)
            self._lead(box, at, radius)
            note(self.axes, text, (box.left, box.bottom + BELOW * SIZE), size=SIZE, **style)

    def _disturbed(self, box: Box, points: Array) -> float:
        """How much of what is drawn lies under a label, or close to it."""
        box = Box(box.left - CLEAR, box.bottom - CLEAR, box.right + CLEAR, box.top + CLEAR)
        on_line = (points >= [box.left, box.bottom]) & (points <= [box.right, box.top])
        lines = ON_LINE * float(np.count_nonzero(on_line.all(axis=1)))
        return lines + ON_MARK * sum(map(box.meets, self.marks))

    def _lead(self, box: Box, at: Array, radius: float) -> None:
        """A thin line from a label to its mark, if that is far."""
        end = np.clip(at, [box.left, box.bottom], [box.right, box.top])
        if np.hypot(*(end - at)) > radius + LED:
            self.axes.plot(*np.array([at, end]).T, color="#9aa5ae", linewidth=0.6, zorder=3.5)


def _boxes(at: Array, distance: float, wide: float) -> Iterable[Box]:
    """The places of a label of this width about a mark."""
    half = np.array([0.5 * wide, 0.5 * (ABOVE + BELOW) * SIZE])
    for side in SIDES:
        along = distance if 0 in side else 0.7 * distance
        middle = at + np.array(side) * (along + half)
        yield Box(*(middle - half), *(middle + half))
