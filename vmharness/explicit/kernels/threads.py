"""*CONTROL_PARALLEL NCPU: the elements of a model, computed by several threads.

The elements of a large part become NCPU forces, each of a run of them (`shares`), and each thread has its own list of
forces and its own sums f and moment. These are added to the state's in the order of the threads: the same bits run
after run, though not the bits of another NCPU.
"""

import copy
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import Any

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.control.parallel import CONTROL_PARALLEL
from vmharness.explicit.force import Elements, Force
from vmharness.explicit.kernels.compiled import concurrent
from vmharness.explicit.model.state import Array, State

FEWEST = 1000  # elements in a share: below, handing work to a thread costs more than it saves


def ncpu(deck: Deck) -> int:
    """How many threads the deck asks for."""
    control = deck.first(CONTROL_PARALLEL)
    return int(control.ncpu) if control else 1


def shares(elements: int, threads: int) -> Iterator[slice]:
    """Runs of elements of about equal length, one for each thread; fewer where they would be too short.

    >>> list(shares(5000, 2)), list(shares(1500, 2))
    ([slice(0, 2500, None), slice(2500, 5000, None)], [slice(0, 1500, None)])
    """
    count = max(1, min(threads, elements // FEWEST))
    ends = np.linspace(0, elements, count + 1).astype(int).tolist()
    return (slice(*pair) for pair in pairwise(ends))


class Crew:
    """Threads that each add the forces of their list; the first is the caller's, and has all that are not elements."""

    def __init__(self, forces: list[Force], state: State, threads: int) -> None:
        self.state, self.lists = state, divided(forces, threads)
        self.others = [(some, _other(state)) for some in self.lists[1:] if some]
        self.pool = ThreadPoolExecutor(len(self.others)) if self.others else None
        self.runs = list(shares(len(state.x), threads))
        self.collect = self.over_nodes(collect)

    def add_forces(self) -> None:
        """f and moment of the state, which are zero, become the sums of all forces at t_n."""
        waiting = [self.pool.submit(self._add, *other) for other in self.others] if self.pool else ()
        for force in self.lists[0]:
            force.add(self.state)
        for done in waiting:
            other = done.result()
            self.collect(self.state.f, self.state.moment, other.f, other.moment)

    def over_nodes(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """A kernel over all nodes, computed for runs of them at once; what it returns, if anything, is summed."""
        pool = self.pool
        if pool is None:
            return function

        def by_runs(*arguments: Any) -> Any:
            cut = [[a[run] if isinstance(a, np.ndarray) else a for a in arguments] for run in self.runs]
            waiting = [pool.submit(function, *own) for own in cut[1:]]
            returned = [function(*cut[0]), *(done.result() for done in waiting)]
            return None if returned[0] is None else sum(returned)

        return by_runs

    def _add(self, forces: list[Force], other: State) -> State:
        other.t, other.dt, other.cycle = self.state.t, self.state.dt, self.state.cycle
        for force in forces:
            force.add(other)
        return other


def divided(forces: list[Force], threads: int) -> list[list[Force]]:
    """A list for each thread, with about as many elements as any other."""
    lists: list[list[Force]] = [[] for _ in range(threads)]
    loads = [0] * threads
    for force in forces:
        least = loads.index(min(loads)) if isinstance(force, Elements) else 0
        lists[least].append(force)
        loads[least] += force.eid.size if isinstance(force, Elements) else 0
    return lists


def _other(state: State) -> State:
    """The same nodes in the same motion, with forces of their own."""
    other = copy.copy(state)
    other.f, other.moment = np.zeros_like(other.f), np.zeros_like(other.moment)
    return other


@concurrent
def collect(f: Array, moment: Array, own: Array, own_moment: Array) -> None:
    """f += own, moment += own moment, which are then zero for the next cycle."""
    for i in range(f.shape[0]):
        for j in range(3):
            f[i, j] += own[i, j]
            moment[i, j] += own_moment[i, j]
            own[i, j] = 0.0
            own_moment[i, j] = 0.0
