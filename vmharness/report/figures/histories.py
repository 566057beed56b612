"""Computed history with theory over it, events marked, and the difference below."""

from typing import TYPE_CHECKING

import numpy as np

from vmharness.events import Event
from vmharness.report.figures import svg
from vmharness.report.figures.characters import ten_to, unit
from vmharness.report.figures.curves import Curve
from vmharness.result import CaseRun

if TYPE_CHECKING:
    from matplotlib.axes import Axes

COLOURS = ("#0b5394", "#b45309", "#3f7d20", "#7b3294", "#444444")  # apart in print and for the colour-blind
MARKERS = ("o", "s", "D", "^", "v")
THEORY_EVERY = 12
QUIET, INK = "#5b6670", "#1b2733"
LETTER = 0.0105  # width of a letter of a title, as a fraction of the axes


def draw(run: CaseRun, name: str, together: list[Curve], solver: str) -> str:
    """SVG of curves of one unit: computed as lines, theory as hollow marks, their difference below."""
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context(svg.STYLE):
        figure = Figure(figsize=(7.4, 5.1))
        above, below = figure.subplots(2, 1, sharex=True, height_ratios=(2.6, 1.2))
        figure.subplots_adjust(left=0.115, right=0.975, top=0.87, bottom=0.095, hspace=0.1)
        above.set_xlim(together[0].time[0], together[0].time[-1])
        _values(above, together, solver, quantity(run, together))
        _residuals(below, together)
        _events(above, below, run)
        below.set_xlabel(f"Time ({run.case.file.units.time})")
        figure.align_ylabels([above, below])
        labels = ", ".join(curve.label.lower() for curve in together)
        return svg.text(figure, f"{run.case.id}-{name}", f"Computed and theoretical history: {labels}")


def quantity(run: CaseRun, together: list[Curve]) -> str:
    """What the curves of a figure are, together."""
    if len(together) > 1 and all(run.case.file.channels[curve.channel].energy for curve in together):
        return "Energy"
    return ", ".join(curve.label for curve in together)


def _values(axes: "Axes", together: list[Curve], solver: str, quantity: str) -> None:
    alone = len(together) == 1
    for number, (curve, colour, marker) in enumerate(zip(together, COLOURS, MARKERS, strict=False)):
        axes.plot(
            curve.time,
            curve.computed,
            color=colour,
            linewidth=1.5,
            label=solver if alone else f"{curve.label}, {solver}",
        )
        # Marks of several curves take turns, so that they do not hide one another.
        marked = slice(THEORY_EVERY * number // len(together), None, THEORY_EVERY)
        axes.plot(
            curve.time[marked],
            curve.theory[marked],
            linestyle="none",
            marker=marker,
            markersize=4.2,
            markerfacecolor="white",
            markeredgecolor=colour,
            clip_on=False,
            label="theory" if alone else f"{curve.label}, theory",
        )
    axes.set_ylabel(_axis(quantity, unit(together[0].unit)))
    axes.margins(y=0.08)
    axes.legend(loc="best", framealpha=0.92, edgecolor="none", fontsize=8, handlelength=1.8)
    _grid(axes)


def _residuals(axes: "Axes", together: list[Curve]) -> None:
    """Computed minus theory, in a power of ten of the unit, with the tolerances of the results at their events."""
    reach = [float(np.abs(curve.residual).max()) for curve in together]
    reach += [allowed for curve in together for _, allowed in curve.allowed.values()]
    power = int(np.floor(np.log10(max(reach)))) if max(reach) > 0.0 else 0
    scale = 10.0**-power
    axes.axhline(0.0, color=QUIET, linewidth=0.6)
    for curve, colour in zip(together, COLOURS, strict=False):
        axes.plot(curve.time, curve.residual * scale, color=colour, linewidth=1.2)
        for t, allowed in curve.allowed.values():
            axes.errorbar(t, 0.0, yerr=allowed * scale, color=colour, capsize=3.5, elinewidth=1.0)
    limit = 1.2 * max(reach) * scale or 1.0
    axes.set_ylim(-limit, limit)
    axes.set_ylabel(_axis("Difference", " ".join(filter(None, [ten_to(power), unit(together[0].unit)]))))
    axes.locator_params(axis="y", nbins=5)
    _grid(axes)


def _events(above: "Axes", below: "Axes", run: CaseRun) -> None:
    """A vertical line where each event was found, its title on top; titles that would collide take turns upward."""
    first, last = above.get_xlim()
    level, reached = 0, -np.inf
    found = {name: event for name, event in run.events.items() if isinstance(event, Event)}
    for name, event in sorted(found.items(), key=lambda item: item[1].time):
        t, title = float(f"{event.time:.6g}"), run.case.file.events[name].title
        for axes in (above, below):
            axes.axvline(t, color=QUIET, linewidth=0.8, linestyle=(0, (4, 3)), zorder=0.5)
        half = LETTER * max(len(title), 10) / 2
        middle = min((t - first) / (last - first), 1.04 - half)
        level = 1 - level if middle - half < reached else 0
        reached = middle + half
        above.annotate(
            f"{title}\n{t:.6g} {run.case.file.units.time}",
            (middle, 1.0),
            (0, 5 + 24 * level),
            xycoords="axes fraction",
            textcoords="offset points",
            ha="center",
            va="bottom",
            fontsize=8,
            color=INK,
            linespacing=1.25,
        )


def _grid(axes: "Axes") -> None:
    axes.grid(True)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def _axis(label: str, unit_text: str) -> str:
    return f"{label} ({unit_text})" if unit_text else label

