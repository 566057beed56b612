"""Work of a worker that calls what it is given."""

from collections.abc import Iterator, Sequence
from functools import partial
from importlib import import_module
from typing import Any

from vmharness.execution.message import Done, Lost, Raised
from vmharness.execution.pool import Pool
from vmharness.execution.worker import Report, Work

Call = partial[Any]  # of a function and arguments that can be pickled


def calling(*needed: str) -> Work:
    """In a worker: import the modules `needed`; the work is to make a call."""
    for module in needed:
        import_module(module)

    def work(call: Call, progress: Report) -> Any:
        return call()

    return work


def called(pool: Pool, calls: Sequence[Call], timeout: float) -> Iterator[tuple[int, Done | Raised | Lost]]:
    """Yield (number of the call, how it ended); `timeout` is the limit of each."""
    for number, message in pool.each(calls, timeout):
        if isinstance(message, Done | Raised | Lost):
            yield number, message
