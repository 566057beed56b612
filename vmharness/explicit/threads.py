"""*CONTROL_PARALLEL NCPU: the forces of a model, computed by several threads.

The elements of a large part become NCPU forces, each of consecutive elements (`shares`). Each thread has its own list
of forces and its own sums f and moment, which are added to those of the state in the order of the threads. Results are
therefore the same bits in every run with the same NCPU, though not the bits of another NCPU.
"""

import copy
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import Any

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.control.parallel import CONTROL_PARALLEL
from vmharness.deck.rule import at_least, no_effect
from vmharness.deck.support import supports
from vmharness.explicit.force import Elements, Force
from vmharness.explicit.kernels.compiled import concurrent
from vmharness.explicit.state import Array, State

SUPPORTS = (
    supports(
        CONTROL_PARALLEL,
        ncpu=at_least(1),
        numrhs=no_effect("each thread has forces of its own"),
        const=no_effect("results do not depend on the number of threads, except for round-off"),
        para=no_effect("of how LS-DYNA adds up forces"),
    ),
)

FEWEST = 1000  # elements in a share: below, handing work to a thread costs more than it saves


def ncpu(deck: Deck) -> int:
    """How many threads the deck asks for."""
    control = deck.first(CONTROL_PARALLEL)
    return int(control.ncpu) if control else 1


def shares(elements: int, threads: int) -> Iterator[slice]:
    """Slices of consecutive elements, of about equal length, one for each thread; fewer where they would be short.

    >>> list(shares(5000, 2)), list(shares(1500, 2))
    ([slice(0, 2500, None), slice(2500, 5000, None)], [slice(0, 1500, None)])
    """
    count = max(1, min(threads, elements // FEWEST))
    ends = np.linspace(0, elements, count + 1).astype(int).tolist()
    return (slice(*pair) for pair in pairwise(ends))


class ThreadPool:
    """Threads that each add the forces of one list; the first is the caller, and has all forces but elements'."""

    def __init__(self, forces: list[Force], state: State, threads: int) -> None:
        first, *others = divided(forces, threads)
        self.state, self.forces = state, first  # of the calling thread
        self.others = [(some, _own_forces(state)) for some in others if some]
        self.executor = ThreadPoolExecutor(len(self.others)) if self.others else None
        self.runs = list(shares(len(state.x), threads))
        self.add_sums = self.over_nodes(add_sums)

    def add_forces(self) -> None:
        """Add the forces and moments of all at t_n to those of the state, which are zero."""
        waiting = [self.executor.submit(self._add, *other) for other in self.others] if self.executor else ()
        for force in self.forces:
            force.add(self.state)
        for done in waiting:
            other = done.result()
            self.add_sums(self.state.f, self.state.moment, other.f, other.moment)

    def over_nodes(self, kernel: Callable[..., Any]) -> Callable[..., Any]:
        """The kernel over all nodes, run by each thread for a range of them; returned numbers are summed."""
        executor = self.executor
        if executor is None:
            return kernel

        def by_runs(*arguments: Any) -> Any:
            cut = [[a[run] if isinstance(a, np.ndarray) else a for a in arguments] for run in self.runs]
            waiting = [executor.submit(kernel, *own) for own in cut[1:]]
            returned = [kernel(*cut[0]), *(done.result() for done in waiting)]
            return None if returned[0] is None else sum(returned)

        return by_runs

    def _add(self, forces: list[Force], other: State) -> State:
        other.t, other.dt, other.cycle = self.state.t, self.state.dt, self.state.cycle
        for force in forces:
            force.add(other)
        return other


def divided(forces: list[Force], threads: int) -> list[list[Force]]:
    """A list for each thread, with about as many elements as any other; the first has what is not elements."""
    lists: list[list[Force]] = [[] for _ in range(threads)]
    sizes = [0] * threads
    for force in forces:
        least = sizes.index(min(sizes)) if isinstance(force, Elements) else 0
        lists[least].append(force)
        sizes[least] += force.eid.size if isinstance(force, Elements) else 0
    return lists


def _own_forces(state: State) -> State:
    """A state of the same arrays, but with forces and moments of its own."""
    other = copy.copy(state)
    other.f, other.moment = np.zeros_like(other.f), np.zeros_like(other.moment)
    return other


@concurrent
def add_sums(f: Array, moment: Array, own: Array, own_moment: Array) -> None:
    """f += own, moment += own moment; the sums of the thread are then zero for the next cycle."""
    for i in range(f.shape[0]):
        for j in range(3):
            f[i, j] += own[i, j]
            moment[i, j] += own_moment[i, j]
            own[i, j] = 0.0
            own_moment[i, j] = 0.0
