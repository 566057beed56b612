"""A deck as arrays over nodes, forces and constraints: what the time loop steps."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Entry
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.energy import KineticEnergy
from vmharness.explicit.force import Elements, Force
from vmharness.explicit.model.state import Array, Index, State


@dataclass
class Model:
    """Nodes, forces and constraints of a deck, in consistent units."""

    ids: NDArray[np.int64]  # (n,) node numbers of the deck, by row of the state's arrays; see `centre`
    x0: Array  # (n, 3) initial coordinates
    state: State
    end_time: float
    end_cycle: int
    step_factor: float  # TSSFAC
    order: Index  # (n,) rows in the order of their numbers
    ncpu: int = 1  # threads that compute the elements
    dtmin: float = 0.0  # the run ends with an error below this fraction of its first step
    caps: list[Callable[[float], float]] = field(default_factory=list)  # t -> the longest step allowed
    facts: dict[str, str] = field(
        default_factory=dict
    )  # what building it changed, for the reader of the results
    forces: list[Force] = field(default_factory=list)
    constraints: list[Constraint] = field(default_factory=list)
    inverse_mass: Array = field(default_factory=lambda: np.zeros(0))  # (n,), 0 where a node has none
    inverse_inertia: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        self.kinetic = KineticEnergy(self.state)

    def find(self, entry: Entry, name: str, ids: NDArray[np.int64], ground: bool = False) -> Index:
        """Rows (m,) of the nodes `ids`, a column of `entry`; raises DeckError at the first that is no node.

        With `ground`, the number 0 stands for the ground: row -1.
        """
        rows = np.where(ground & (ids == 0), -1, self._nearest(ids))
        for index in np.flatnonzero(((self.ids[rows] != ids) | (ids < 0)) & (rows >= 0)):
            raise entry.error(name, f"no *NODE {ids[index]}", int(index))
        return rows

    def centre(self, number: int) -> int:
        """The row of the centre of a rigid body; its number in `ids` is minus that of the body."""
        return int(self._nearest(-number))

    @property
    def node_count(self) -> int:
        """Number of rows that are nodes of the deck; the others are centres of rigid bodies."""
        return int(np.count_nonzero(self.ids > 0))

    def corners(self, table: Entry, names: Sequence[str], ground: bool = False) -> Index:
        """Rows (m, corners) of the nodes that the columns `names` of a table give; see `find`."""
        return np.column_stack([self.find(table, name, getattr(table, name), ground) for name in names])

    def row(self, entry: Entry, name: str, nid: int, index: int | None = None) -> int:
        """The row of node `nid`; raises DeckError naming the card and field that refer to it."""
        row = int(self._nearest(nid))
        if self.ids[row] != nid or nid < 0:
            raise entry.error(name, f"no *NODE {nid}", index)
        return row

    def _nearest(self, ids: NDArray[np.int64] | int) -> Index:
        """Rows of the nodes `ids`; the row of another node for a number without a node."""
        place = np.searchsorted(self.ids, ids, sorter=self.order)
        return np.asarray(self.order[np.minimum(place, self.ids.size - 1)])

    def add_mass(self, rows: Index, mass: Array, inertia: Array | float = 0.0) -> None:
        """Lump `mass` (m,) and `inertia` onto nodes; a row may come several times."""
        np.add.at(self.state.mass, rows, mass)
        np.add.at(self.state.inertia, rows, inertia)

    @cached_property
    def blocks(self) -> list[Elements]:
        """The forces that are elements, listed at the first call."""
        return [force for force in self.forces if isinstance(force, Elements)]

    def next_step(self) -> float:
        """The step from t_n on: TSSFAC times the shortest stable step of all elements, or the smallest cap."""
        stable = [self.step_factor * block.stable_step() for block in self.blocks]
        limits = stable + [cap(self.state.t) for cap in self.caps]
        return min(limits) if limits else math.inf

    def largest_acceleration(self) -> str:
        """Where the largest acceleration is, or the first that is not a number."""
        largest = np.abs(np.hstack([self.state.a, self.state.alpha])).max(axis=1)
        number = self.ids[np.argmax(np.where(np.isnan(largest), np.inf, largest))]
        return f"first seen at {'node' if number > 0 else 'rigid body'} {abs(number)}"

    def controlling(self) -> str:
        """Name the elements that set the time step."""
        return f"set by {min(self.blocks, key=lambda block: block.stable_step()).name}" if self.blocks else ""
