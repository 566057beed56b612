"""Start and duration of a run and of each of its cases."""

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime

from vmharness.execution import message
from vmharness.suite.outcome import Outcome

Event = tuple[int, message.Message | Outcome]


def now() -> str:
    """The time in UTC, to the second.

    >>> now()[10], now()[-1]
    ('T', 'Z')
    """
    return datetime.now(UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


@dataclass(frozen=True)
class Began:
    """How and when a run began."""

    command: Sequence[str]
    started: str
    at: float  # by the clock of time.perf_counter


def timed(events: Iterator[Event]) -> Iterator[Event]:
    """The events of a run, in which each outcome says when its case began and how long it took."""
    began: dict[int, tuple[str, float]] = {}
    for number, event in events:
        if isinstance(event, message.Began):
            began[number] = now(), time.perf_counter()
        if isinstance(event, Outcome) and number in began:
            started, at = began[number]
            event = replace(event, started=started, seconds=time.perf_counter() - at)
        yield number, event
