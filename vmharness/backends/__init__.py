"""Solvers, one a file; the folder is the list."""

from collections.abc import Callable
from typing import Protocol, cast

from vmharness import plugins
from vmharness.case import Case
from vmharness.result import Solution


class Backend(Protocol):
    """A module of this folder: a solver that can run a case's deck."""

    def solve(self, case: Case, progress: Callable[[float], None] | None) -> Solution:
        """Run the deck and record the case's channels; what goes wrong is said in the solution's `failure`."""


def names() -> list[str]:
    """The solvers that there are."""
    return plugins.names(__name__)


def backend(name: str) -> Backend:
    """The solver `name`; raises KeyError if the folder has none of that name."""
    if name not in names():
        raise KeyError(name)
    return cast(Backend, plugins.module(__name__, name))
