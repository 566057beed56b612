"""Limits of the memory of this process, so that too large a demand is a MemoryError and not the end of the machine."""

import contextlib
import os
from collections.abc import Iterator
from pathlib import Path

GIGABYTE = 2**30  # bytes
STATM = Path("/proc/self/statm")


@contextlib.contextmanager
def at_most(more: int) -> Iterator[None]:
    """Let the process use `more` bytes than it has now, at most; beyond, Python raises MemoryError.

    Without /proc (other systems than Linux) there is no limit.
    """
    if not STATM.exists():
        yield
        return
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    limit = _used() + more
    if soft == resource.RLIM_INFINITY or limit < soft:
        resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def at_most_that_of_the_machine() -> None:
    """Let the process use no more memory than the machine has: it would be killed, and others with it."""
    if not STATM.exists():
        return
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    limit = _used() + os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    if soft == resource.RLIM_INFINITY or limit < soft:
        resource.setrlimit(resource.RLIMIT_AS, (limit, hard))


def _used() -> int:
    """Bytes of address space that the process has."""
    return int(STATM.read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
