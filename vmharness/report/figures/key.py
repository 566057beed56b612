"""Key of a drawing: a line, a mark and a name for each entry.

A legend of matplotlib is laid out by the size of its letters, which is up to the version of a font; this one stands
where it is put.
"""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from vmharness.report.figures.note import MIDDLE, note

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Entry: TypeAlias = tuple[str, dict[str, Any]]  # what it is, and how its line and mark are drawn
SAMPLE = 20.0  # length of a line in the key, in points
LEFT, WIDTH = 43.0, 432.0  # of a key below a drawing, in points
LETTER = 4.4  # width of a letter, in points, where many stand together
ROW = 16.0  # points


def columns(labels: Iterable[str], most: int) -> int:
    """Number of entries in a row below a drawing: at most `most`, fewer for long labels.

    >>> columns(["z", "v"], 3), columns(["Displacement of the front end", "z"], 3), columns(["z" * 60], 3)
    (3, 2, 1)
    """
    needed = SAMPLE + 8.0 + LETTER * max(map(len, labels), default=0)
    return max(1, min(most, int(WIDTH / needed)))


def key_below(figure: "Figure", entries: Sequence[Entry], side_by_side: int) -> None:
    """Write the entries in rows from the left, the last of them at the lower edge."""
    rows = [entries[first : first + side_by_side] for first in range(0, len(entries), side_by_side)]
    for number, row in enumerate(reversed(rows)):
        key(figure, row, start=(LEFT, 12.0 + ROW * number), step=(WIDTH / side_by_side, 0.0))


def key(
    figure: "Figure", entries: Sequence[Entry], start: tuple[float, float], step: tuple[float, float]
) -> None:
    """Write the entries, the first at `start` and each `step` further, both in points from the lower left corner."""
    width, height = 72.0 * figure.get_size_inches()
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, width), ylim=(0.0, height), facecolor="none")
    axes.set_axis_off()
    for number, (label, style) in enumerate(entries):
        sample(axes, label, style, start[0] + number * step[0], start[1] + number * step[1])


def sample(axes: "Axes", label: str, style: dict[str, Any], x: float, y: float) -> None:
    """Draw an entry at x, y: its line and mark, and beside them its label."""
    axes.plot([x, x + SAMPLE / 2, x + SAMPLE], [y, y, y], markevery=[1], **style)
    lines = label.count("\n")
    note(axes, label, (x + SAMPLE + 8, y), (0, 9 * MIDDLE - 5.85 * lines), color="#1b2733")
