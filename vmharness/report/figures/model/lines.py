"""Beams, and what may touch: segments, tracked nodes, and lines between them."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.view import View
from vmharness.report.figures.model.frame import Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import BEAM, CONTACT, MANY, TOUCH, TOUCHING
from vmharness.round_off import smallest

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]

DENSE = 250  # tracked nodes that are drawn, at most twice as many: more would lie on one another


def draw_beams(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """A line for each deformable beam."""
    from matplotlib.collections import LineCollection

    if view.beams.size:
        lines = list(frame.at(view.x[view.beams]))
        axes.add_collection(
            LineCollection(lines, zorder=2, colors=BEAM["color"], linewidths=BEAM["linewidth"])
        )
        for line in lines:
            labels.avoid_line(line)


def draw_contacts(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """Segments of contacts in their colour, and the tracked nodes; of few, a line to the nearest segment."""
    from matplotlib.collections import PolyCollection

    for tracked, segments in view.contacts:
        corners = list(frame.at(view.x[segments]))
        axes.add_collection(
            PolyCollection(corners, facecolors=TOUCH, edgecolors="none", alpha=0.16, zorder=1.5)
        )
        small = {"markersize": 1.6} if tracked.size > MANY else {}
        shown = tracked[:: max(1, tracked.size // DENSE)]
        axes.plot(*frame.at(view.x[shown]).T, zorder=4.1, **TOUCHING | small)
        if segments.size and tracked.size <= MANY:
            for node in tracked:
                line = frame.at(np.array([view.x[node], _nearest(view, node, segments)]))
                labels.avoid_line(line)
                axes.plot(*line.T, zorder=3, **CONTACT)


def _nearest(view: View, node: int, segments: NDArray[np.intp]) -> Array:
    """The middle of the segment that is nearest to a node."""
    middle = view.x[segments].mean(axis=1)
    far = np.linalg.norm(middle - view.x[node], axis=1).tolist()
    return np.asarray(middle[smallest(range(len(far)), far.__getitem__)])
