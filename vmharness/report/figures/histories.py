"""Computed history and theory, with events, and their difference below."""

from textwrap import fill
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from vmharness.events import Event
from vmharness.report.figures import svg
from vmharness.report.figures.characters import ten_to, unit
from vmharness.report.figures.curves import Curve, time_factor, time_unit
from vmharness.report.figures.key import Entry, columns, key_below
from vmharness.report.figures.note import note
from vmharness.result import CaseRun
from vmharness.round_off import ordered, rounded

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = ("#0b5394", "#b45309", "#3f7d20", "#7b3294", "#444444")  # apart in print and for the colour-blind
MARKERS = ("o", "s", "D", "^", "v")
THEORY_EVERY = 12
QUIET, INK = "#5b6670", "#1b2733"
LETTER = 0.011  # width of a letter of a title, as a fraction of the axes
LINE = 85  # letters of the axes' own title, which is of more lines where it is longer
IN_A_ROW = 3  # entries of the key
TITLE = 24 / 72  # inches from the title of an event to that above it
TITLED = 0.3  # of the axes, where at least their own title stands


def draw(run: CaseRun, name: str, together: list[Curve], solver: str) -> str:
    """SVG of curves of one unit: computed as lines, theory as hollow marks, their difference below."""
    from matplotlib.figure import Figure

    with svg.style(f"{run.case.id}-{name}"):
        entries = _entries(together, solver)
        side_by_side = columns([label for label, _ in entries], IN_A_ROW)
        under = 0.57 + 0.22 * -(
            -len(entries) // side_by_side
        )  # inches: labels of time, and the rows of the key
        first, last = float(together[0].time[0]), float(together[0].time[-1])
        size = max(float(np.abs([curve.computed, curve.theory]).max()) for curve in together)
        title = _titled(quantity(run, together), _in(_power(size), unit(together[0].unit)))
        places = _places(run, first, last, title)
        rest = 4.3 + under  # inches: all but what titles of events need beyond two rows
        height = rest + TITLE * max((level - 1 for *_, level in places if level), default=0)
        figure = Figure(figsize=(6.6, height))
        above, below = _panels(figure, under / height, 0.865 * rest / height)
        above.set_xlim(first, last)
        _values(above, together)
        _written_in(above, "y", _power(size))
        _written_in(below, "x", _power(last))
        _residuals(below, together)
        _events(above, below, run, places)
        _title(above, title)
        time = f"Time ({_in(_power(last), unit(time_unit(run.case)))})"
        note(below, time, (1.0, 0.0), (0, -26), xycoords="axes fraction", ha="right", color=INK)
        key_below(figure, entries, side_by_side)
        labels = ", ".join(curve.label.lower() for curve in together)
        return svg.text(figure, f"Computed and theoretical history: {labels}")


def _panels(figure: "Figure", bottom: float, top: float) -> tuple["Axes", "Axes"]:
    """Axes for values and, below, for differences, over one axis of time."""
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(2.6, 1.2))
    figure.subplots_adjust(left=0.09, right=0.97, top=top, bottom=bottom, hspace=0.24)
    for axes in (above, below):
        axes.grid(True)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
    return above, below


def quantity(run: CaseRun, together: list[Curve]) -> str:
    """The common name of the curves of a figure."""
    if len(together) > 1 and all(run.case.file.channels[curve.channel].energy for curve in together):
        return "Energy"
    return joined([curve.label for curve in together])


def joined(labels: list[str]) -> str:
    """Labels in a row; common first words are written once.

    >>> joined(["Displacement of the front end", "Displacement of the free end"]), joined(["Kinetic", "Potential"])
    ('Displacement of the front end, free end', 'Kinetic, Potential')
    """
    words = [label.split() for label in labels]
    shortest = min(map(len, words))
    same = next((n for n in range(shortest - 1) if len({each[n] for each in words}) > 1), shortest - 1)
    return ", ".join([labels[0], *(" ".join(each[same:]) for each in words[1:])])


def _entries(together: list[Curve], solver: str) -> list[Entry]:
    """The key: line and mark of a single curve, or the name of each of several curves."""
    if len(together) == 1:
        return [(solver, _line(0)), ("theory", _mark(0))]
    return [
        (curve.label, {**_line(number), **_mark(number), "linestyle": "-"})
        for number, curve in enumerate(together)
    ]


def _line(number: int) -> dict[str, Any]:
    return {"color": COLOURS[number % len(COLOURS)], "linewidth": 1.5}


def _mark(number: int) -> dict[str, Any]:
    return {
        "linestyle": "none",
        "marker": MARKERS[number % len(MARKERS)],
        "markersize": 4.2,
        "markerfacecolor": "white",
        "markeredgecolor": COLOURS[number % len(COLOURS)],
        "clip_on": False,
    }


def _values(axes: "Axes", together: list[Curve]) -> None:
    for number, curve in enumerate(together):
        axes.plot(curve.time, curve.computed, **_line(number))
        # Marks of several curves take turns, so that they do not hide one another.
        marked = slice(THEORY_EVERY * number // len(together), None, THEORY_EVERY)
        axes.plot(curve.time[marked], curve.theory[marked], **_mark(number))
    axes.margins(y=0.08)


def _residuals(axes: "Axes", together: list[Curve]) -> None:
    """Computed minus theory, in a power of ten of the unit, with the tolerances of the results at their events."""
    reach = [float(np.abs(curve.residual).max()) for curve in together]
    reach += [allowed for curve in together for _, allowed in curve.allowed.values()]
    power = _power(max(reach), most=1)
    scale = 10.0**-power
    axes.axhline(0.0, color=QUIET, linewidth=0.6)
    for number, curve in enumerate(together):
        axes.plot(curve.time, curve.residual * scale, **_line(number))
        for t, allowed in curve.allowed.values():
            axes.errorbar(
                t, 0.0, yerr=allowed * scale, color=_line(number)["color"], capsize=3.5, elinewidth=1.0
            )
    limit = 1.2 * max(reach) * scale or 1.0
    axes.set_ylim(-limit, limit)
    _title(axes, _titled("Difference from theory", _in(power, unit(together[0].unit))))
    axes.locator_params(axis="y", nbins=5)


def _places(run: CaseRun, first: float, last: float, title: str) -> list[tuple[str, float, float, int]]:
    """Name and time of each event; where its title stands along the axes, as a fraction, and in which row.

    It is the lowest row with room. In the first, which has two lines, the own `title` of the axes comes before.
    """
    found = {
        name: float(f"{event.time / time_factor(run.case):.6g}")
        for name, event in run.events.items()
        if isinstance(event, Event)
    }
    places, reached = [], [max(TITLED, LETTER * max(map(len, title.split("\n"))))]
    for name, t in ordered(found.items(), lambda item: item[1]):
        half = LETTER * max(len(run.case.file.events[name].title), 10) / 2
        middle = min((t - first) / (last - first), 1.02 - half)
        level = next((row for row, end in enumerate(reached) if middle - half >= end), len(reached))
        reached[level:] = [middle + half, *reached[level + 1 :]]
        places.append((name, t, middle, level))
    return places


def _events(above: "Axes", below: "Axes", run: CaseRun, places: list[tuple[str, float, float, int]]) -> None:
    """A vertical line where each event was found, its title on top."""
    for name, t, middle, level in places:
        title = run.case.file.events[name].title
        for axes in (above, below):
            axes.axvline(t, color=QUIET, linewidth=0.8, linestyle=(0, (4, 3)), zorder=0.5)
        note(
            above,
            f"{title}\n{t:.6g} {unit(time_unit(run.case))}",
            (middle, 1.0),
            (0, 6 + 72 * TITLE * level),
            size=8,
            xycoords="axes fraction",
            ha="center",
            color=INK,
        )


def _power(size: float, most: int = 4) -> int:
    """The power of ten in which numbers up to `size` are written; 0 for one between -`most` and `most`.

    >>> _power(1.6e11), _power(3e-8), _power(25000.0), _power(0.0)
    (11, -8, 0, 0)
    """
    power = int(f"{rounded(size):e}".partition("e")[2]) if size > 0.0 else 0
    return power if abs(power) > most else 0


def _written_in(axes: "Axes", which: Literal["x", "y"], power: int) -> None:
    """Write the numbers of an axis as multiples of a power of ten, which the title of the axis names."""
    if power:
        axes.ticklabel_format(axis=which, style="sci", scilimits=(power, power), useOffset=False)
    else:
        axes.ticklabel_format(axis=which, style="plain", useOffset=False)
    axis = {"x": axes.xaxis, "y": axes.yaxis}[which]
    axis.get_offset_text().set_visible(False)


def _in(power: int, unit_text: str) -> str:
    return " ".join(filter(None, [ten_to(power), unit_text]))


def _titled(what: str, unit_text: str) -> str:
    """The title of a vertical axis with its unit, in lines that fit the axes."""
    return fill(f"{what} ({unit_text})" if unit_text else what, LINE)


def _title(axes: "Axes", title: str) -> None:
    """Write the title of the vertical axis above it."""
    note(axes, title, (0.0, 1.0), (0, 7), xycoords="axes fraction", color=INK)
