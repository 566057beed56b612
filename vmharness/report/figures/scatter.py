"""Shares of tolerances over each datum of a sweep: one panel for each datum, one mark for each point."""

import math
from typing import TYPE_CHECKING

from vmharness.report import number
from vmharness.report.figures import svg
from vmharness.report.figures.characters import ten_to, unit
from vmharness.report.figures.histories import COLOURS, INK, QUIET
from vmharness.report.figures.note import note
from vmharness.round_off import rounded
from vmharness.studies.sweep.record import SweepRecord, worst_share
from vmharness.studies.sweep.sampling import is_logarithmic

if TYPE_CHECKING:
    from matplotlib.axes import Axes

IN_A_ROW = 3
HEIGHT = 1.75  # of a row of panels, in inches
LEAST = 1e-4  # shares below are drawn there


def draw(found: SweepRecord) -> str:
    """SVG of the largest share of a tolerance that a result uses at each point, over each datum."""
    from matplotlib.figure import Figure

    rows = -(-len(found.ranges) // IN_A_ROW)
    height = 0.35 + HEIGHT * rows
    with svg.style(f"{found.case}-sweep"):
        figure = Figure(figsize=(6.6, height))
        for i, name in enumerate(found.ranges):
            left = 0.075 + 0.315 * (i % IN_A_ROW)
            bottom = (HEIGHT * (rows - 1 - i // IN_A_ROW) + 0.5) / height
            axes = figure.add_axes((left, bottom, 0.275, (HEIGHT - 0.62) / height), yscale="log")
            _panel(axes, found, name, named=i % IN_A_ROW == 0)
        corner = figure.add_axes((0.075, 1.0 - 0.2 / height, 0.9, 0.0))
        corner.set_axis_off()
        note(corner, "Largest share of a tolerance", (0.0, 0.0), (0, 0), xycoords="axes fraction", color=INK)
        return svg.text(figure, "Largest share of a tolerance over each datum")


def _panel(axes: "Axes", found: SweepRecord, name: str, named: bool) -> None:
    """The points over one datum: failing points are filled, points without a verdict are left out."""
    shares = {i: worst_share(found, i) for i in range(found.points) if i not in found.unjudged}
    top = max([1.0, *(share for share in shares.values() if math.isfinite(share))])
    axes.set_ylim(LEAST / 1.5, 3.0 * top)
    if is_logarithmic(found.ranges[name]):
        axes.set_xscale("log")
    axes.grid(True)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.axhline(1.0, color=QUIET, linewidth=0.8)
    for fails, colour, size in ((False, COLOURS[0], 2.2), (True, COLOURS[1], 4.0)):
        chosen = [i for i, share in shares.items() if (not share <= 1.0) is fails]
        # Dots are lines of no length with round ends: all of them are one path, a tenth of as many marks.
        x = [value for i in chosen for value in (found.data[name][i],) * 2 + (math.nan,)]
        y = [value for i in chosen for value in (min(max(shares[i], LEAST), 2.0 * top),) * 2 + (math.nan,)]
        (dots,) = axes.plot(x, y, color=colour, linewidth=size, solid_capstyle="round")
        dots.get_path().should_simplify = False
    _ticks(axes, found, name, named)


def _ticks(axes: "Axes", found: SweepRecord, name: str, named: bool) -> None:
    """Ends and middle of the range; powers of ten of the share."""
    from matplotlib.ticker import FixedFormatter, FixedLocator, LogLocator, NullLocator

    low, high = found.ranges[name]
    middle = math.sqrt(low * high) if is_logarithmic((low, high)) else 0.5 * (low + high)
    axes.xaxis.set_major_locator(FixedLocator([low, middle, high]))
    axes.xaxis.set_major_formatter(FixedFormatter([number.short(rounded(x, 2)) for x in (low, middle, high)]))
    first, *_, last = axes.get_xticklabels()
    first.set_horizontalalignment("left")
    last.set_horizontalalignment("right")
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_locator(LogLocator(10.0, numticks=9))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(
        lambda value, _: (ten_to(round(math.log10(value))) or "1") if named else ""
    )
    in_unit = f" ({unit(found.units[name])})" if found.units[name] else ""
    note(axes, f"{name}{in_unit}", (1.0, 0.0), (0, -24), xycoords="axes fraction", ha="right", color=INK)
