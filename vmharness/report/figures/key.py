"""The key of a drawing: a line and a mark for each thing in it, and what it is.

A legend of matplotlib is laid out by the size of its letters, which is up to the version of a font; this one stands
where it is put.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from vmharness.report.figures.note import MIDDLE, note

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Entry: TypeAlias = tuple[str, dict[str, Any]]  # what it is, and how its line and mark are drawn
SAMPLE = 20.0  # length of a line in the key, in points


def key(
    figure: "Figure", entries: Sequence[Entry], start: tuple[float, float], step: tuple[float, float]
) -> None:
    """Write the entries, the first at `start` and each `step` further, both in points from the lower left corner."""
    width, height = 72.0 * figure.get_size_inches()
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, width), ylim=(0.0, height), facecolor="none")
    axes.set_axis_off()
    for number, (label, style) in enumerate(entries):
        x, y = start[0] + number * step[0], start[1] + number * step[1]
        axes.plot([x, x + SAMPLE / 2, x + SAMPLE], [y, y, y], markevery=[1], **style)
        lines = label.count("\n")
        note(axes, label, (x + SAMPLE + 8, y), (0, 9 * MIDDLE - 5.5 * lines), color="#1b2733")
