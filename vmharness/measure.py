"""Measurement of the declared events and channels of a case in a history."""

from vmharness.case import Case, format
from vmharness.events import Event, EventError, crossings, ends, find, minima, onsets
from vmharness.history import History, HistoryError


def find_event(case: Case, name: str, history: History) -> Event | str:
    """The declared event, or a sentence with the reason why it is not found."""
    event = case.file.events[name]
    try:
        if event.at is not None:
            return _given(case.evaluate(f"at {name}"), history)
        channel = watched(event)
        time, values = history.time_of(channel), history[channel]
        if event.onset_of:
            return find(onsets, time, values, event.times, event.pick)
        if event.end_of:
            return find(ends, time, values, event.times, event.pick)
        if event.minimum_of:
            return find(minima, time, values, event.times, event.pick)
        if event.maximum_of:
            return find(minima, time, -values, event.times, event.pick)
        assert event.direction is not None
        level, direction = case.evaluate(f"level {name}"), event.direction
        return find(lambda t, y: crossings(t, y, level, direction), time, values, event.times, event.pick)
    except (EventError, HistoryError) as error:
        return f"{event.title}: {error}"


def watched(event: format.Event) -> str:
    """The channel in which the event is found; `time` for a given time."""
    of = (event.onset_of, event.end_of, event.crossing_of, event.minimum_of, event.maximum_of)
    return next((channel for channel in of if channel), "time")


def _given(t: float, history: History) -> Event:
    """The event at a given time, which has no uncertainty."""
    if not history.time[0] <= t <= history.time[-1]:
        raise EventError(f"t = {t:.7g} lies outside the run, {history.time[0]:.7g} to {history.time[-1]:.7g}")
    return Event(t, 0.0)


def value_at(history: History, channel: str, t: float) -> float:
    """The value of a channel at the time t, interpolated, in consistent units; `time` is t itself."""
    return t if channel == "time" else float(history.at(channel, [t])[0])
