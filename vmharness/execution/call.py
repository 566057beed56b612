"""Work of a worker that calls what it is given."""

import contextlib
import traceback
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from importlib import import_module
from typing import Any

from vmharness.execution.message import Done, Lost, Raised
from vmharness.execution.pool import Pool
from vmharness.execution.worker import Report, Work

Call = partial[Any]  # of a function and arguments that can be pickled
End = Done | Raised | Lost
Caller = Callable[[Call], End]


def calling(*needed: str) -> Work:
    """In a worker: import the modules `needed`; the work is to make a call."""
    imported(*needed)

    def work(call: Call, progress: Report) -> Any:
        return call()

    return work


def imported(*modules: str) -> None:
    """Import the modules; an error shows where one of them is used."""
    for module in modules:
        with contextlib.suppress(Exception):
            import_module(module)


def called(pool: Pool, calls: Sequence[Call], timeout: float) -> Iterator[tuple[int, End]]:
    """Yield (number of the call, how it ended); `timeout` is the limit of each."""
    for number, message in pool.each(calls, timeout):
        if isinstance(message, End):
            yield number, message


def caller(pool: Pool, timeout: float, *needed: str) -> Caller:
    """Makes one call after the other in a pool of one worker, with the limit `timeout` for each.

    The worker begins at once to import the modules `needed`, and goes on with it while its caller does other things.
    """
    imports = pool.each([partial(imported, *needed)])
    next(imports)

    def call(one: Call) -> End:
        for _ in imports:
            pass
        ((_, end),) = called(pool, [one], timeout)
        return end

    return call


def here(call: Call) -> End:
    """Make a call in this process, without a limit."""
    try:
        return Done(call())
    except Exception as error:
        return Raised(f"{type(error).__name__}: {error}", traceback.format_exc())
