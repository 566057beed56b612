"""The session of a worker: the worker and every process that it starts, which all end together."""

import contextlib
import os
import signal
from collections.abc import Iterator
from multiprocessing import parent_process
from multiprocessing.connection import wait
from pathlib import Path
from threading import Thread

PROC = Path("/proc")
SESSION = 3  # field of /proc/PID/stat, counted from after the name


def lead() -> None:
    """Make this process the leader of a new session, and end the session when the parent process ends."""
    if hasattr(os, "setsid"):
        os.setsid()
    if (parent := parent_process()) is not None:
        Thread(target=_end_with, args=(parent.sentinel,), daemon=True).start()


def end(leader: int) -> None:
    """Kill every process of a session, also those in process groups other than the leader's."""
    for process in _members(leader):  # mpirun, for example, makes a group for each of its processes
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.kill(process, signal.SIGKILL)
    if hasattr(os, "killpg"):
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(leader, signal.SIGKILL)


def _end_with(parent: int) -> None:
    """Wait until the parent has ended, also by SIGKILL, then end this session."""
    wait([parent])
    end(os.getpid())


def _members(leader: int) -> Iterator[int]:
    """The processes of a session except its leader; without /proc none, and `end` reaches the leader's group only."""
    for stat in PROC.glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            after_name = stat.read_text(errors="replace").rpartition(")")[2].split()
            if int(after_name[SESSION]) == leader and int(stat.parent.name) != leader:
                yield int(stat.parent.name)
