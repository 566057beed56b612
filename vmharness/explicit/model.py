"""A deck as arrays over nodes, forces and constraints: what the time loop steps."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from vmharness import dropins
from vmharness.deck import Deck, DeckError, Entry
from vmharness.deck.keywords.control_termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control_timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.node import NODE
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.energy import KineticEnergy
from vmharness.explicit.force import Elements, Force
from vmharness.explicit.rigid.numbers import numbers
from vmharness.explicit.state import Array, State
from vmharness.explicit.threads import ncpu

# Folders whose modules each add to the model by `build(deck, model)`. Supports come late: they overrule velocities.
# Damping comes after them: it acts on the accelerations that all others have left. Rigid walls see what is then left
# of motion along their normal. Mass scaling needs all elements, and rigid bodies need all mass.
PARTS = (
    "elements", "contacts", "loads", "initial", "constraints", "damping", "walls", "timestep", "bodies",
)  # fmt: skip


@dataclass
class Model:
    """Nodes with mass, what pushes on them, and what rules their motion; consistent units."""

    ids: NDArray[np.int64]  # (n,) node numbers of the deck, by row of the state's arrays; see `centre`
    x0: Array  # (n, 3) initial coordinates
    state: State
    end_time: float
    end_cycle: int
    step_factor: float  # TSSFAC
    order: NDArray[np.intp]  # (n,) rows in the order of their numbers
    ncpu: int = 1  # threads that compute the elements
    dtmin: float = 0.0  # the run ends with an error below this fraction of its first step
    caps: list[Callable[[float], float]] = field(default_factory=list)  # t -> the longest step allowed
    facts: dict[str, str] = field(default_factory=dict)  # what building it did and a reader must know
    forces: list[Force] = field(default_factory=list)
    constraints: list[Constraint] = field(default_factory=list)
    inverse_mass: Array = field(default_factory=lambda: np.zeros(0))  # (n,), 0 where a node has none
    inverse_inertia: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        self.kinetic = KineticEnergy(self.state)

    def find(self, entry: Entry, name: str, ids: NDArray[np.int64], ground: bool = False) -> NDArray[np.intp]:
        """Rows (m,) of the nodes `ids`, a column of `entry`; raises DeckError at the first that is no node.

        With `ground`, the number 0 is no node but the ground: row -1.
        """
        rows = np.where(ground & (ids == 0), -1, self._nearest(ids))
        for index in np.flatnonzero(((self.ids[rows] != ids) | (ids < 0)) & (rows >= 0)):
            raise entry.error(name, f"no *NODE {ids[index]}", int(index))
        return rows

    def centre(self, number: int) -> int:
        """The row of the centre of a rigid body: after those of the nodes, numbered by the body's number negated."""
        return int(self._nearest(-number))

    @property
    def node_count(self) -> int:
        """How many rows are nodes of the deck."""
        return int(np.count_nonzero(self.ids > 0))

    def corners(self, table: Entry, names: Sequence[str], ground: bool = False) -> NDArray[np.intp]:
        """Rows (m, corners) of the nodes that the columns `names` of a table give; see `find`."""
        return np.column_stack([self.find(table, name, getattr(table, name), ground) for name in names])

    def row(self, entry: Entry, name: str, nid: int, index: int | None = None) -> int:
        """The row of node `nid`; raises DeckError naming the card and field that refer to it."""
        row = int(self._nearest(nid))
        if self.ids[row] != nid or nid < 0:
            raise entry.error(name, f"no *NODE {nid}", index)
        return row

    def _nearest(self, ids: NDArray[np.int64] | int) -> NDArray[np.intp]:
        """Rows of `ids` where they are nodes, else of some other node."""
        place = np.searchsorted(self.ids, ids, sorter=self.order)
        return np.asarray(self.order[np.minimum(place, self.ids.size - 1)])

    def add_mass(self, rows: NDArray[np.intp], mass: Array, inertia: Array | float = 0.0) -> None:
        """Lump `mass` (m,) and `inertia` onto nodes; a row may come several times."""
        np.add.at(self.state.mass, rows, mass)
        np.add.at(self.state.inertia, rows, inertia)

    @cached_property
    def blocks(self) -> list[Elements]:
        """The forces that are elements, as they are when first asked for."""
        return [force for force in self.forces if isinstance(force, Elements)]

    def next_step(self) -> float:
        """The step from t_n on: TSSFAC times the shortest that any elements set, or what caps it."""
        stable = [self.step_factor * block.stable_step() for block in self.blocks]
        limits = stable + [cap(self.state.t) for cap in self.caps]
        return min(limits) if limits else math.inf

    def wildest(self) -> str:
        """Which node is accelerated most, or beyond all numbers."""
        largest = np.abs(np.hstack([self.state.a, self.state.alpha])).max(axis=1)
        number = self.ids[np.argmax(np.where(np.isnan(largest), np.inf, largest))]
        return f"first seen at {'node' if number > 0 else 'rigid body'} {abs(number)}"

    def controlling(self) -> str:
        """Which elements set the time step."""
        return f"set by {min(self.blocks, key=lambda block: block.stable_step()).name}" if self.blocks else ""


def build(deck: Deck) -> Model:
    """The model of a deck; raises DeckError for what cannot be built, or could move without having mass."""
    model = _nodes(deck)
    for part in PARTS:
        for module in dropins.modules(f"vmharness.explicit.{part}"):
            module.build(deck, model)
    _check_masses(deck, model)
    _check_histories(deck, model)
    s = model.state
    model.inverse_mass = np.divide(1.0, s.mass, out=np.zeros_like(s.mass), where=s.mass > 0.0)
    model.inverse_inertia = np.divide(1.0, s.inertia, out=np.zeros_like(s.inertia), where=s.inertia > 0.0)
    return model


def _nodes(deck: Deck) -> Model:
    tables = deck.all(NODE)
    if not tables:
        raise DeckError("no *NODE in the deck", str(deck.path.name), 1)
    bodies = np.array(numbers(deck), np.int64)
    ids = np.concatenate([*(table.nid for table in tables), -bodies])
    x = np.concatenate([
        *(np.column_stack([table.x, table.y, table.z]) for table in tables), np.zeros((bodies.size, 3))
    ])  # fmt: skip
    n = ids.size
    state = State(x.copy(), np.zeros((n, 3)), np.zeros((n, 3)), np.zeros(n), np.zeros(n))
    termination = deck.one(CONTROL_TERMINATION)
    timestep = deck.first(CONTROL_TIMESTEP)
    return Model(
        ids=ids,
        x0=x,
        state=state,
        end_time=termination.endtim,
        end_cycle=termination.endcyc or np.iinfo(np.int64).max,
        step_factor=timestep.tssfac if timestep else 0.9,
        dtmin=termination.dtmin,
        ncpu=ncpu(deck),
        order=np.argsort(ids),
    )


def _check_masses(deck: Deck, model: Model) -> None:
    """A node that could move, but has no mass, would move with infinite acceleration."""
    held = np.zeros((model.ids.size, 6), bool)
    for constraint in model.constraints:
        held |= constraint.fixed
    loose = (model.state.mass <= 0.0) & ~held[:, :3].all(axis=1)
    if not loose.any():
        return
    nid = model.ids[np.flatnonzero(loose)[0]]
    for table in deck.all(NODE):
        for row in np.flatnonzero(table.nid == nid):
            others = f" ({loose.sum()} such nodes)" if loose.sum() > 1 else ""
            raise table.error(
                "nid", f"a free node without mass{others}; give it mass, or support it", int(row)
            )


def _check_histories(deck: Deck, model: Model) -> None:
    """A node whose history the deck asks for must be there: else the name is wrong, or the mesh."""
    for keyword, ids in (("DATABASE_HISTORY_NODE", "ids"), ("DATABASE_HISTORY_NODE_ID", "id1")):
        for table in deck.all(keyword):
            model.find(table, ids, getattr(table, ids))
