"""Data for which the events of a case happen: those of its region, for which theory has the events within the run."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from vmharness.case import Case
from vmharness.deck import Deck
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.formula import FormulaError
from vmharness.history import History, HistoryError
from vmharness.measure import find_event
from vmharness.review.run_length import outside_run
from vmharness.round_off import ROUND_OFF

SAMPLES = 1001  # of a curve of theory over the run


def outside(case: Case, data: Mapping[str, float], own: Case, deck: Deck) -> list[str]:
    """Sentences on `data`, each in its unit, for which the events of the case do not happen.

    `case` and its `deck` have these data, `own` has those of the file.
    """
    if found := outside_sweep(case, data, own):
        return found
    return outside_run(case, deck) or without_events(case, deck)


def outside_sweep(case: Case, data: Mapping[str, float], own: Case) -> list[str]:
    """Sentences on data outside the ranges of [sweep], and on its constraints that they do not meet.

    The data of the case's file, `own`, belong to the region, also where a constraint leaves them out of the sweep.
    """
    plan = case.file.sweep
    if plan is None:
        return []
    found = []
    for name in data.keys() & plan.ranges.keys():
        what = f"{name} = {data[name]:g}"
        found += _not_between(
            data[name], (*plan.ranges[name], own.datum(name)), what, case.file.given[name].unit
        )
    if found:
        return found
    for number, each in enumerate(plan.within, 1):
        value, known = case.evaluate(f"within {number}"), own.evaluate(f"within {number}")
        what = f"{each.formula} = {value:.4g}"
        found += _not_between(value, (each.low, each.high, known), what, f": {each.because}")
    return found


def _not_between(value: float, ends: tuple[float, ...], what: str, end: str) -> list[str]:
    low, high = min(ends), max(ends)
    if low - ROUND_OFF * abs(low) <= value <= high + ROUND_OFF * abs(high):
        return []
    return [
        f"{what} is outside the region of the case, {low:g} to {high:g} {end}".replace(" :", ":").rstrip()
    ]


def without_events(case: Case, deck: Deck) -> list[str]:
    """Sentences on events that do not happen, or not as often as declared, in the curves of theory over the run."""
    time = np.linspace(0.0, deck.one(CONTROL_TERMINATION).endtim, SAMPLES)
    curves = {
        name: event.of
        for name, event in case.file.events.items()
        if event.of in case.file.curves and not (event.onset_of or event.end_of)
    }
    missing = {name: _missing(case, name, channel, time) for name, channel in curves.items()}
    return [f"[events] {name}: by theory: {what}" for name, what in missing.items() if what]


def _missing(case: Case, name: str, channel: str, time: NDArray[np.float64]) -> str:
    """Why an event is not found in the curve of its channel, or nothing."""
    try:
        with np.errstate(all="ignore"):
            found = find_event(case, name, History(time, {channel: case.curve(channel, time)}))
    except (FormulaError, HistoryError) as error:
        found = f"{channel}: {error}"
    return found if isinstance(found, str) else ""
