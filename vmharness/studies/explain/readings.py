"""Ways of reading a history, tried one by one: which of them gives the digits of a published column.

A solver writes states at an interval, and a reader takes one state for the event, without interpolation. The best
reading gives the most printed figures. Among equal ones, a round interval comes first, then the largest, because the
readings of fine states all come close to the history itself. The other intervals are named.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from vmharness.case import Case
from vmharness.case.format import Published
from vmharness.history import History
from vmharness.reading import FIRST, LAST, prints_as, read_off, said, states
from vmharness.studies.thinning import read_all

STEPS = (1.0, 2.0, 2.5, 5.0)  # usual intervals, times a power of ten
FEWEST = 10  # states in a run, at least
MOST = 20_000  # states in a run, at most: a finer interval is close to the history itself


@dataclass(frozen=True)
class Reading:
    """One way of reading a history, and the values that it gives."""

    interval: float  # consistent units; 0 for the whole history, read between its samples
    written: str  # the time of each state, in words
    taken: str  # the state that is taken for an event, in words; empty for the whole history
    values: Mapping[str, float]  # by key, in the results' units
    same: tuple[str, ...]  # keys whose printed digits it gives
    also: tuple[float, ...] = ()  # other intervals that give just as many, read the same way

    def says(self, unit: str) -> str:
        """The reading in words."""
        return said(self.interval, unit, self.written, self.taken) if self.interval else self.written


def best(case: Case, history: History, column: Published) -> Reading:
    """The reading that gives the most figures; the whole history with interpolation if none gives more."""
    found = [plain(case, history, column), *_all(case, history, column, list(column.values))]
    chosen = max(found, key=_worth)
    alike = [
        one
        for one in found
        if (one.written, one.taken) == (chosen.written, chosen.taken) and len(one.same) == len(chosen.same)
    ]
    return replace(chosen, also=tuple(one.interval for one in alike if one.interval != chosen.interval))


def rest(case: Case, history: History, column: Published, but: Reading) -> Reading | None:
    """The reading at the same interval that gives most of the figures that `but` does not; None without one."""
    keys = [key for key in column.values if key not in but.same]
    found = [one for one in _all(case, history, column, keys) if one.same and one.interval == but.interval]
    return max(found, key=_worth, default=None)


def plain(case: Case, history: History, column: Published) -> Reading:
    """The reading with interpolation between all samples."""
    values = {key: value for key, value in read_all(case, history).items() if value is not None}
    return _judged(0.0, "every cycle, with interpolation", "", values, column, list(column.values))


def intervals(history: History) -> Iterator[float]:
    """Intervals to try: 1, 2, 2.5 and 5 times powers of ten, from a tenth of the run down to two cycles."""
    span = float(history.time[-1] - history.time[0])
    shortest = max(2.0 * span / (len(history) - 1), span / MOST)
    for power in range(math.floor(math.log10(span)), math.floor(math.log10(shortest)) - 1, -1):
        for step in sorted(STEPS, reverse=True):
            interval = float(f"{step}e{power}")
            if shortest <= interval <= span / FEWEST:
                yield interval


def _worth(reading: Reading) -> tuple[int, bool, float]:
    """Rank of a reading: the number of figures, then the plain reading, then a round and a large interval."""
    if reading.interval == 0.0:
        return len(reading.same), True, math.inf
    return len(reading.same), f"{reading.interval:e}".startswith("1.000000"), reading.interval


def _all(case: Case, history: History, column: Published, keys: list[str]) -> Iterator[Reading]:
    for interval in intervals(history):
        for how, written in WRITTEN.items():
            sampled = written(history, interval)
            for which, before in ((FIRST, 0), ("the event is read one state before it shows", 1)):
                values = _values(case, sampled, keys, before)
                yield _judged(interval, how, which, values, column, keys)


def _judged(
    interval: float, written: str, taken: str, values: Mapping[str, float], column: Published, keys: list[str]
) -> Reading:
    same = tuple(key for key in keys if key in values and prints_as(values[key], column.values[key]))
    return Reading(interval, written, taken, values, same)


def _values(case: Case, sampled: History, keys: list[str], before: int) -> dict[str, float]:
    """The results without interpolation; an onset may be taken `before` states early."""
    found = {key: read_off(case, sampled, key, before) for key in keys}
    return {key: read[1] for key, read in found.items() if read is not None}


def _last_cycle(history: History, interval: float) -> History:
    return history.samples(states(history, interval))


def _next_cycle(history: History, interval: float) -> History:
    nominal = _nominal(history, interval)
    found = np.searchsorted(history.time, nominal - 1e-9 * interval)
    return history.samples(np.unique(found[found < len(history)]))


def _exactly(history: History, interval: float) -> History:
    nominal = _nominal(history, interval)
    # Linear interpolation between samples keeps a force zero until it begins.
    channels = {name: np.interp(nominal, history.time, values) for name, values in history.channels.items()}
    return History(nominal, channels)


def _nominal(history: History, interval: float) -> np.ndarray:
    count = math.floor((history.time[-1] - history.time[0]) / interval * (1.0 + 1e-12))
    return np.asarray(history.time[0] + interval * np.arange(count + 1))


WRITTEN: dict[str, Callable[[History, float], History]] = {
    LAST: _last_cycle,
    "each at exactly its nominal time": _exactly,
    "each is the first cycle from its nominal time on": _next_cycle,
}
