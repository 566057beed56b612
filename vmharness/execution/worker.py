"""A worker process: takes tasks from a pipe, one after the other, and answers on it.

Nothing heavy may be imported by this module: the thread limits must stand in the environment before numpy is.
"""

import contextlib
import os
import signal
import time
import traceback
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

from vmharness.execution.garbage import collect_rarely
from vmharness.execution.memory import at_most_that_of_the_machine
from vmharness.execution.message import Done, Progress, Raised, Ready
from vmharness.execution.session import lead

Report = Callable[[float], None]
Work = Callable[[Any, Report], Any]

ONE_THREAD = ("NUMBA_NUM_THREADS", "OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
PROGRESS_INTERVAL = 0.1  # seconds between messages


def serve(connection: Connection, prepare: Callable[..., Work], arguments: tuple[Any, ...]) -> None:
    """Do `prepare(*arguments)(task, progress)` for every task until the other end of the pipe closes.

    What is prepared (imports, above all) is so while the first task is still on its way. The process then ends at once,
    without Python's own end: a thread that is in C++ there, as an import can be, would abort the process.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent decides
    lead()
    collect_rarely()
    os.environ.update(dict.fromkeys(ONE_THREAD, "1"))
    at_most_that_of_the_machine()
    prepared = _attempt(prepare, *arguments)
    with contextlib.suppress(EOFError, ConnectionError):  # the parent is gone
        connection.send(Ready())
        while True:
            task = connection.recv()
            answer = prepared
            if isinstance(prepared, Done):
                answer = _attempt(prepared.value, task, _reporter(connection))
            _send(connection, answer)
    os._exit(0)


def _attempt(function: Callable[..., Any], *arguments: Any) -> Done | Raised:
    try:
        return Done(function(*arguments))
    except Exception as error:
        return _raised(error)


def _raised(error: Exception) -> Raised:
    return Raised(f"{type(error).__name__}: {error}", traceback.format_exc())


def _reporter(connection: Connection) -> Report:
    """A progress function that sends at most ten messages a second."""
    last = -PROGRESS_INTERVAL

    def report(fraction: float) -> None:
        nonlocal last
        if (now := time.monotonic()) - last >= PROGRESS_INTERVAL:
            last = now
            connection.send(Progress(fraction))

    return report


def _send(connection: Connection, answer: Done | Raised) -> None:
    try:
        connection.send(answer)
    except ConnectionError:
        raise
    except Exception as error:  # the value cannot be pickled; nothing of it was sent
        connection.send(_raised(error))
