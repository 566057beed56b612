"""Parts of errors as bars: one bar for each result, one colour for each cause, positive parts to the right."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vmharness.report.figures import svg
from vmharness.report.figures.histories import COLOURS, INK, QUIET
from vmharness.report.figures.key import columns, key_below
from vmharness.report.figures.note import MIDDLE, note

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ROW = 0.3  # inches of a bar
IN_A_ROW = 3


def draw(name: str, bars: Mapping[str, Mapping[str, float]], causes: Sequence[str], what: str) -> str:
    """SVG of the parts by label, then by cause; `what` they are fractions of, in percent. A diamond marks the sum."""
    from matplotlib.figure import Figure

    side_by_side = columns(causes, IN_A_ROW)
    keys = -(-len(causes) // side_by_side)
    under, above = 0.55 + 0.22 * keys, ROW * len(bars) + 0.25
    with svg.style(name):
        height = under + above
        figure = Figure(figsize=(6.6, height))
        axes = figure.add_axes((0.22, under / height, 0.74, (above - 0.1) / height))
        axes.spines[["top", "right", "left"]].set_visible(False)
        axes.set_yticks([])
        axes.grid(True, axis="x")
        axes.set_axisbelow(True)
        axes.axvline(0.0, color=QUIET, linewidth=0.8)
        for row, (label, parts) in enumerate(bars.items()):
            _bar(axes, -row, label, parts, causes)
        axes.set_ylim(0.6 - len(bars), 0.6)
        note(axes, what, (1.0, 0.0), (0, -26), xycoords="axes fraction", ha="right", color=INK)
        styles = [{"color": _colour(causes, cause), "linewidth": 7.0} for cause in causes]
        key_below(figure, list(zip(causes, styles, strict=True)), side_by_side)
        return svg.text(figure, f"Parts of the errors, {what[0].lower()}{what[1:]}")


def _bar(axes: "Axes", y: float, label: str, parts: Mapping[str, float], causes: Sequence[str]) -> None:
    """One bar: positive parts to the right of each other, negative ones to the left."""
    ends = {True: 0.0, False: 0.0}
    for cause in causes:
        value = parts.get(cause, 0.0)
        if value:
            side = value > 0.0
            axes.barh(y, value, left=ends[side], height=0.55, color=_colour(causes, cause), linewidth=0.0)
            ends[side] += value
    axes.plot([sum(parts.values())], [y], "D", markersize=4.2, color=INK, markerfacecolor="white")
    note(axes, label, (0.0, y), (-6, 9 * MIDDLE), xycoords=("axes fraction", "data"), ha="right", color=INK)


def _colour(causes: Sequence[str], cause: str) -> str:
    """The colour of a cause; the unexplained rest is grey."""
    number = list(causes).index(cause)
    return "#b9c0c6" if number == len(causes) - 1 else COLOURS[number % len(COLOURS)]
