"""A deck as arrays over nodes, forces and constraints: what the time loop steps."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from vmharness.deck import Finding
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.energy import KineticEnergy
from vmharness.explicit.force import Elements, Force
from vmharness.explicit.state import Array, Index, State
from vmharness.mesh.nodes import Nodes


@dataclass
class Model(Nodes):
    """Nodes, forces and constraints of a deck, in consistent units.

    `ids` are node numbers of the deck, by row of the state's arrays, then those of centres: see `centre`.
    """

    state: State
    end_time: float
    end_cycle: int
    step_factor: float  # TSSFAC
    ncpu: int = 1  # threads that compute the elements
    dtmin: float = 0.0  # the run ends with an error below this fraction of its first step
    caps: list[Callable[[float], float]] = field(default_factory=list)  # t -> the longest step allowed
    rigid_step: float = math.inf  # of the elements of rigid bodies, if they were elastic
    facts: dict[str, str] = field(
        default_factory=dict
    )  # what building it changed, for the reader of the results
    idle: list[Finding] = field(default_factory=list)  # what of the deck has no effect
    forces: list[Force] = field(default_factory=list)
    constraints: list[Constraint] = field(default_factory=list)
    inverse_mass: Array = field(default_factory=lambda: np.zeros(0))  # (n,), 0 where a node has none
    inverse_inertia: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        self.kinetic = KineticEnergy(self.state)

    def centre(self, number: int) -> int:
        """The row of the centre of a rigid body; its number in `ids` is minus that of the body."""
        return int(self._nearest(-number))

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
