"""Worker processes that are spawned, reused, and replaced when they crash or hang."""

import contextlib
import math
import multiprocessing
import signal
import time
from collections import deque
from collections.abc import Callable, Generator, Iterator, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from types import TracebackType
from typing import Any

from vmharness.execution.message import Began, Lost, Message, Progress, Raised, Ready, ending
from vmharness.execution.session import end
from vmharness.execution.worker import Work, serve

IDLE = -1
OUTSIDE = (
    "SIGKILL",
    "SIGTERM",
    "SIGHUP",
    "SIGXCPU",
)  # from the system, as where memory runs out, or from its user
PREPARING = 300.0  # seconds: the longest that imports may take, on a machine that is busy
SPAWN = multiprocessing.get_context("spawn")  # a fork would inherit the threads and locks of numpy and numba


@dataclass
class Worker:
    """A process, our end of its pipe, what it was prepared with, whether it is so, and the number of its task."""

    process: SpawnProcess
    connection: Connection
    arguments: tuple[Any, ...]
    ready: bool = False
    task: int = IDLE
    deadline: float = math.inf  # of the task; until the worker is ready, of its preparation
    ended: bool = False


class Pool:
    """`count` workers that each do `prepare(*arguments)` once, and what that returns for every task.

    A context manager: on leaving it, whatever is still running is killed, with the programs that it has started.
    """

    def __init__(self, count: int, prepare: Callable[..., Work], *arguments: Any) -> None:
        self._prepare = prepare
        self._arguments = arguments
        self._workers = [self._start(arguments) for _ in range(count)]

    def __enter__(self) -> "Pool":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        for worker in self._workers:
            _kill(worker)

    def each(
        self,
        tasks: Sequence[Any],
        timeout: float = math.inf,
        arguments: Sequence[tuple[Any, ...]] | None = None,
    ) -> Generator[tuple[int, Message], None, None]:
        """Yield (number of the task, message) until every task is Done, Raised or Lost, which each is just once.

        A task that is not done `timeout` seconds after a worker that is ready has it is lost, and the worker with it.
        So are the workers that are busy when the caller stops to listen: an interrupt, above all.
        `arguments` of a task, in place of the pool's own: a worker that was prepared with others is replaced.
        """
        waiting = deque(enumerate(tasks))
        given = arguments or [self._arguments] * len(tasks)
        try:
            while True:
                for i, worker in enumerate(self._workers):
                    if worker.task == IDLE and waiting:
                        number, task = waiting.popleft()
                        worker = self._workers[i] = self._give(worker, number, task, timeout, given[number])
                        if worker.ready:
                            yield number, Began()
                busy = [worker for worker in self._workers if worker.task != IDLE]
                if not busy:
                    return
                yield from _listen(busy, timeout)
        finally:
            for worker in self._workers:
                if worker.task != IDLE:
                    worker.task = IDLE
                    _kill(worker)

    def _give(
        self, worker: Worker, number: int, task: Any, timeout: float, arguments: tuple[Any, ...]
    ) -> Worker:
        """Send a task to the worker, or to a new one in its place if it is dead or prepared with other arguments.

        Returns the one that has the task.
        """
        if wait([worker.process.sentinel], 0) or worker.arguments != arguments:
            _kill(worker)
            worker = self._start(arguments)
        worker.task = number
        worker.deadline = time.monotonic() + (timeout if worker.ready else PREPARING)
        with contextlib.suppress(ConnectionError):  # it has just died: the end of its pipe will be heard
            worker.connection.send(task)
        return worker

    def _start(self, arguments: tuple[Any, ...]) -> Worker:
        ours, theirs = SPAWN.Pipe()
        process = SPAWN.Process(target=serve, args=(theirs, self._prepare, arguments), daemon=True)
        # An ignored signal stays so in the child, which would else be open to Ctrl-C until its own code runs.
        before = signal.signal(signal.SIGINT, signal.SIG_IGN)
        try:
            process.start()
        finally:
            signal.signal(signal.SIGINT, before)
        theirs.close()
        return Worker(process, ours, arguments)


def _listen(busy: Sequence[Worker], timeout: float) -> Iterator[tuple[int, Message]]:
    """What the workers say next; those whose time is up are killed."""
    now = time.monotonic()
    first = min(worker.deadline for worker in busy)
    ready = wait([worker.connection for worker in busy], None if math.isinf(first) else max(first - now, 0.0))
    for worker in busy:
        message: Message | Ready
        if worker.connection in ready:
            message = _receive(worker)
        elif time.monotonic() >= worker.deadline:
            _kill(worker)
            what = f"done after {timeout:g}" if worker.ready else f"ready to begin after {PREPARING:g}"
            message = Lost(f"not {what} s, the time limit")
        else:
            continue
        number = worker.task
        if not worker.ready:
            worker.ready, worker.deadline = True, time.monotonic() + timeout
            yield number, Began()
        if isinstance(message, Ready):
            continue
        if not isinstance(message, Progress):
            worker.task = IDLE
        yield number, message


def _receive(worker: Worker) -> Message | Ready:
    try:
        message: Message | Ready = worker.connection.recv()
        return message
    except (EOFError, OSError):
        wait([worker.process.sentinel], 1.0)  # it ends by itself, before it is killed for certain
        _kill(worker)
        ended = ending(worker.process.exitcode)
        return Lost(f"the worker process ended: {ended}", outside=ended.endswith(OUTSIDE))
    except Exception as error:  # what came cannot be unpickled
        return Raised(f"{type(error).__name__}: {error}", "")


def _kill(worker: Worker) -> None:
    """End the worker and all that it has started."""
    if worker.ended:
        return
    worker.ended = True
    if worker.process.pid is not None:
        end(worker.process.pid)  # before it is waited for: until then no other process has its number
    worker.process.kill()  # it may not have come to lead a session
    worker.process.join()
    worker.connection.close()
