"""Error against size, both logarithmic: a line for each result, with the slope of the expected order."""

from typing import TYPE_CHECKING, Any

import numpy as np

from vmharness.report.figures import svg
from vmharness.report.figures.characters import ten_to, unit
from vmharness.report.figures.histories import COLOURS, INK, MARKERS, QUIET
from vmharness.report.figures.key import Entry, columns, key_below
from vmharness.report.figures.note import note
from vmharness.round_off import ROUND_OFF
from vmharness.studies.converge.record import ConvergeRecord, Refined
from vmharness.studies.converge.richardson import Kind

if TYPE_CHECKING:
    from matplotlib.axes import Axes

IN_A_ROW = 4


def draw(found: ConvergeRecord) -> str:
    """SVG of |value - target| / |target| of each result over the refined size."""
    from matplotlib.figure import Figure

    shown = [result for result in found.results if errors(found, result)]
    side_by_side = columns([result.key for result in shown], IN_A_ROW)
    rows = -(-len(shown) // side_by_side)
    with svg.style(f"{found.case}-convergence"):
        under = 0.57 + 0.22 * rows  # inches: labels of the size, and the key
        height = 3.4 + under
        figure = Figure(figsize=(6.6, height))
        axes = figure.add_axes((0.09, under / height, 0.88, 3.0 / height), xscale="log", yscale="log")
        axes.grid(True)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
        entries = [_line(axes, found, result, i) for i, result in enumerate(shown)]
        _ticks(axes, found)
        what = "Time step" if found.refined == "time step" else "Size of the elements"
        in_unit = f" ({unit(found.unit)})" if found.unit else ""
        note(axes, f"{what}{in_unit}", (1.0, 0.0), (0, -26), xycoords="axes fraction", ha="right", color=INK)
        note(axes, "Error, as a fraction of the target", (0.0, 1.0), (0, 7), xycoords="axes fraction")
        key_below(figure, entries, side_by_side)
        return svg.text(figure, "Error of the results over the size")


def errors(found: ConvergeRecord, result: Refined) -> list[tuple[float, float]]:
    """(size, |value - target| / |target|) of the levels at which that is more than round-off.

    Nothing where no level differs from the others: what is left there does not fall with the size.
    """
    if result.found.kind is Kind.EXACT:
        return []
    scale = abs(result.target) or 1.0
    pairs = zip(found.levels, result.values, strict=True)
    away = [(level.size, abs(value - result.target) / scale) for level, value in pairs if value is not None]
    return [(size, error) for size, error in away if error > ROUND_OFF]


def _line(axes: "Axes", found: ConvergeRecord, result: Refined, i: int) -> Entry:
    """Draw a result and, dashed, the expected slope through its coarsest level; returns its entry in the key."""
    size, error = np.array(errors(found, result)).T
    style: dict[str, Any] = {
        "color": COLOURS[i % len(COLOURS)],
        "linewidth": 1.2,
        "marker": MARKERS[(i + i // len(COLOURS)) % len(MARKERS)],
        "markersize": 4.2,
        "markerfacecolor": "white",
    }
    axes.plot(size, error, **style)
    if result.promised is not None:
        ends = np.array([size.max(), size.min()])
        slope = error[np.argmax(size)] * (ends / ends[0]) ** result.promised
        axes.plot(ends, slope, color=QUIET, linewidth=0.7, linestyle=(0, (4, 3)), zorder=0.5)
    return result.key, style


def _ticks(axes: "Axes", found: ConvergeRecord) -> None:
    """A tick at each level, its size in words; powers of ten on the vertical axis."""
    from matplotlib.ticker import FixedFormatter, FixedLocator, LogLocator, NullFormatter, NullLocator

    sizes = [level.size for level in found.levels]
    axes.set_xlim(max(sizes) * 1.15, min(sizes) / 1.15)  # finer to the right
    axes.xaxis.set_major_locator(FixedLocator(sizes))
    axes.xaxis.set_major_formatter(FixedFormatter([f"{size:.3g}" for size in sizes]))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_locator(LogLocator(10.0, numticks=9))
    axes.yaxis.set_major_formatter(lambda value, _: ten_to(round(np.log10(value))) or "1")
    axes.yaxis.set_minor_formatter(NullFormatter())
