"""What a worker process says of a task, and what the pool says where the worker no longer can."""

import signal
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Ready:
    """The worker is prepared; the pool keeps this message to itself."""


@dataclass(frozen=True)
class Began:
    """A worker that is ready has the task: its time begins."""


@dataclass(frozen=True)
class Progress:
    """How far the task is, from 0 to 1."""

    fraction: float


@dataclass(frozen=True)
class Done:
    """The task returned `value`."""

    value: Any


@dataclass(frozen=True)
class Raised:
    """The task raised an exception."""

    error: str
    traceback: str


@dataclass(frozen=True)
class Lost:
    """The worker crashed, or was killed after its time was up; or from `outside`, which says nothing of the task."""

    reason: str
    outside: bool = False


Message = Began | Progress | Done | Raised | Lost


def ending(code: int | None) -> str:
    """How a process ended, in words.

    >>> ending(-11), ending(3)
    ('killed by SIGSEGV', 'exit code 3')
    """
    if code is not None and code < 0:
        return f"killed by {signal.Signals(-code).name}"
    return f"exit code {code}"
