"""Reading of a history from states at an interval, as a published column may have been read.

A code that writes states at a nominal interval writes each at the last cycle up to the nominal time. A reader who takes
the first state with contact, or the lowest state, without interpolation, measures the interval and not the code.
"""

from decimal import Decimal

import numpy as np
from numpy.typing import NDArray

from vmharness.case import Case
from vmharness.case.format import Event, Published
from vmharness.formula import Unit
from vmharness.history import History
from vmharness.measure import value_at, watched
from vmharness.result import Reading
from vmharness.round_off import ROUND_OFF

LAST = "each is the last cycle up to its nominal time"
FIRST = "the event is read at the first state that shows it"


def readings(case: Case, history: History) -> dict[str, tuple[Reading, ...]]:
    """For each published column that declares an interval: its values, and those of our history read in that way."""
    return {
        column.name: _column(case, history, column, column.interval)
        for column in case.published
        if column.interval is not None
    }


def states(history: History, interval: float) -> NDArray[np.intp]:
    """Indices of the samples that are states: the last sample up to each nominal time 0, T, 2T, ...

    Of an interval below the steps every sample is a state.
    """
    time = history.time
    if interval <= np.diff(time).min(initial=np.inf):
        return np.arange(time.size)
    # The time is accumulated: a cycle after the nominal time by round-off alone still counts.
    late = 1e-9 * interval
    # For each sample the first nominal time not before it: there may be too many nominal times to list.
    nominal = interval * np.maximum(np.ceil((time - late) / interval), 0.0)
    following = np.append(time[1:], np.inf)
    chosen = (nominal + late < following) & (nominal < time[-1] * (1.0 + 1e-12))
    return np.flatnonzero(chosen)


def _column(case: Case, history: History, column: Published, interval: float) -> tuple[Reading, ...]:
    sampled = history.samples(states(history, interval))
    rows = []
    for result in case.file.results:
        if result.key not in column.values:
            continue
        found = read_off(case, sampled, result.key)
        if found is None:
            continue
        at, read = found
        factor = case.units.factor(Unit(result.unit))
        text = column.values[result.key]
        other = None
        time, t = history.time_of(result.channel), column.exactly_at.get(result.key)
        if t is not None and time[0] <= t <= time[-1]:
            other = (t, value_at(history, result.channel, t) / factor)
        rows.append(
            Reading(
                key=result.key,
                label=result.label,
                unit=result.unit,
                published=text,
                read=read,
                at=at,
                same=prints_as(read, text),
                target=case.target(result.key) / factor,
                other=other,
                other_same=other is not None and prints_as(other[1], text),
            )
        )
    return tuple(rows)


def last_cycles(interval: float, unit: str) -> str:
    """The way in which `readings` reads, in words."""
    return said(interval, unit, LAST, FIRST)


def said(interval: float, unit: str, written: str, taken: str) -> str:
    """A reading in words: the interval of the states, the time of each, and the state taken for an event."""
    return f"states {interval:g} {unit} apart, {written}; {taken}"


def read_off(case: Case, sampled: History, key: str, before: int = 0) -> tuple[float, float] | None:
    """Time and value of the state that a reader without interpolation takes for a result, in the result's unit.

    An onset is taken `before` states early; None if no state shows the event.
    """
    result = case.result(key)
    event = case.file.events[result.event]
    if result.channel not in sampled or watched(event) not in sampled:
        return None
    state = state_of(event, sampled)
    if state is None:
        return None
    if event.onset_of is not None:
        state = max(state - before, 0)
    factor = case.units.factor(Unit(result.unit))
    return float(sampled.time[state]), float(sampled[result.channel][state]) / factor


def state_of(event: Event, sampled: History) -> int | None:
    """Index of the state that a reader without interpolation takes for the event."""
    if event.onset_of:
        on = np.flatnonzero(sampled[event.onset_of] != 0.0)
        return int(on[0]) if on.size else None
    if event.end_of:
        on = np.flatnonzero(sampled[event.end_of] != 0.0)
        return int(on[-1]) if on.size else None
    if event.minimum_of:
        return _lowest(sampled[event.minimum_of])
    if event.maximum_of:
        return _lowest(-sampled[event.maximum_of])
    return None  # a level crossing is not read from states


def _lowest(values: NDArray[np.float64]) -> int:
    """Index of the lowest state; the first of those that are as low but for round-off."""
    return int(np.argmax(values <= values.min() + ROUND_OFF * np.abs(values).max()))


def prints_as(value: float, text: str) -> bool:
    """True if `value`, rounded to the digits of `text`, is `text`.

    >>> prints_as(-1.000462, "-1.0005"), prints_as(193.0879, "193.10")
    (True, False)
    """
    return round(Decimal(value), -int(Decimal(text).as_tuple().exponent)) == Decimal(text)
