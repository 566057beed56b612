"""Text in a drawing, placed line by line by its baseline, which does not depend on the version of the font."""

from typing import TYPE_CHECKING, Any

from vmharness.report.escape import printable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SPACING = 1.3  # lines, in sizes of the letters
MIDDLE = -0.35  # baseline of a line whose middle is at a height, in sizes of the letters
NARROW, WIDE = frozenset("ijltfr.,:;|!'() "), frozenset("mwMW@−+")


def width(text: str, size: float = 9.0, bold: bool = False) -> float:
    """The width of a line of text in points, or somewhat more: that of the letters is up to the version of the font."""
    letters = sum(0.42 if one in NARROW else 1.0 if one in WIDE else 0.65 for one in text)
    return size * letters * (1.12 if bold else 1.0)


def note(
    axes: "Axes",
    text: str,
    at: Any,
    offset: tuple[float, float] = (0.0, 0.0),
    size: float = 9.0,
    **style: Any,
) -> None:
    """Write lines of text as they stand, the last of them with its baseline at `at` plus `offset` (points)."""
    for number, line in enumerate(reversed(printable(text).split("\n"))):
        place = (offset[0], offset[1] + number * SPACING * size)
        axes.annotate(
            line,
            at,
            place,
            textcoords="offset points",
            va="baseline",
            fontsize=size,
            parse_math=False,
            **style,
        )
