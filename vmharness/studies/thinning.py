"""Results read from every n-th sample of a history: the effect of the spacing of the samples on the same motion."""

from vmharness.case import Case
from vmharness.formula import Unit
from vmharness.history import History
from vmharness.measure import find_event, value_at


def phases(case: Case, history: History, stride: int) -> dict[str, list[float | None]]:
    """By key, the results read from the samples n, n + stride, n + 2 stride, ... for n = 0 to stride - 1."""
    found = [read_all(case, history.samples(slice(first, None, stride))) for first in range(stride)]
    return {result.key: [values[result.key] for values in found] for result in case.file.results}


def read_all(case: Case, history: History) -> dict[str, float | None]:
    """Every result of the case in its unit, by key; None if its event is not in the history."""
    events = {name: find_event(case, name, history) for name in case.file.events}
    found: dict[str, float | None] = {}
    for result in case.file.results:
        event = events[result.event]
        found[result.key] = None
        if not isinstance(event, str):
            value = value_at(history, result.channel, event.time)
            found[result.key] = value / case.units.factor(Unit(result.unit))
    return found
