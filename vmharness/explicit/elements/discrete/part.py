"""The springs or dampers of one part, as a force."""

from collections.abc import Callable
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.elements.discrete import step
from vmharness.explicit.elements.discrete.limit import stable_step
from vmharness.explicit.kernels.compiled import specialise
from vmharness.explicit.state import Array, Index, State

ALONG, ABOUT = 0, 1  # DRO

# Unit vectors (ne, 3), zero where there is none; and (ne, 3): two nodes or -1 for the direction between them, and
# whether the axis is the projection on the plane normal to the one or the other.
Orientation = tuple[Array, Index]


class Discrete:
    """Discrete elements of one part: a force with the energy "spring and damper", stored and dissipated.

    `nodes (ne, 2)`: rows of the state's arrays, -1 for the ground; `orientation`: see above; `limits`: CL and FD, 0
    where there is none; `size (ne,)`: S; `offset (ne,)`; `demand (2, n)`: stiffness and damping at the nodes
    of *all* discrete elements that act as these do, filled before the first step. Consistent units.
    """

    kind = "discrete"

    def __init__(
        self,
        name: str,
        pid: int,
        eid: NDArray[np.int64],
        nodes: Index,
        orientation: Orientation,
        limits: tuple[float, float],
        size: Array,
        offset: Array,
        dro: int,
        law: ModuleType,
        constants: tuple[Any, ...],
        demand: Array,
    ) -> None:
        self.name, self.pid, self.eid = name, pid, eid
        self.elongation, self.force = np.zeros(eid.size), np.zeros(eid.size)
        self.energy = {"spring and damper": np.zeros(1)}
        self.nodes, self._size, self._limits = nodes, size, limits
        self._direction, self._guide = orientation
        self._broken = np.zeros(eid.size, np.bool_)
        self.about = dro == ABOUT
        self.demand = demand
        self.bearing: Array | None = None  # (n,) mass or inertia, where rigid bodies have the nodes'
        self.taken = np.zeros(demand.shape[1])  # (n,) mass or inertia over h^2 that other elements need
        self._constants = constants
        self._bounds = law.bounds(constants)
        self._history = np.zeros(law.HISTORY["spring"] * eid.size)
        self._limit = np.inf
        self._step = _compiled(step.step, law.spring)
        if offset.any():
            _compiled(step.preload, law.spring)(
                offset, size, constants, limits[0], self.elongation, self.force, self._history, self._energy
            )

    @property
    def _energy(self) -> Array:
        return self.energy["spring and damper"]

    def add(self, state: State) -> None:
        """Add forces or moments at t_n, and the work of the step that led there."""
        if state.cycle == 0:
            own = state.inertia if self.about else state.mass
            mass = own if self.bearing is None else self.bearing
            taken = np.where(mass == own, self.taken, 0.0)
            self._limit = stable_step(self.nodes, self.demand[0], self.demand[1], mass, taken)
        self._step(
            state.x, state.v, state.omega if self.about else state.v, state.dt,
            self.nodes, self._direction, self._guide, self._size,
            self._constants, self._limits,
            self._broken, self.elongation, self.force, self._history,
            state.moment if self.about else state.f, self._energy,
        )  # fmt: skip

    def stable_step(self) -> float:
        """The limit of the nodes that these elements join, from the bounds of the laws: the same at all times."""
        return self._limit

    def linearised(self) -> "LinearDiscrete":
        """Springs and dampers of the largest stiffness and damping of the law."""
        k, c = self._bounds
        return LinearDiscrete(self, k * self._size, c * self._size)

    def probe(self, element: int, point: int, component: str) -> Callable[[], float]:
        """`force` and `elongation` of an element (its place in `eid`); of a torsional one `moment` and `rotation`."""
        names = ("moment", "rotation") if self.about else ("force", "elongation")
        values = dict(zip(names, (self.force, self.elongation), strict=True))
        if component not in values:
            raise ValueError(f"no {component!r} of this discrete element; there are: {', '.join(names)}")
        column = values[component]
        return lambda: float(column[element])


class LinearDiscrete:
    """Springs of constant stiffness and dampers (ne,), in the places of those of a part."""

    def __init__(self, part: Discrete, stiffness: Array, damping: Array) -> None:
        self.name, self.energy, self.about = part.name, part.energy, part.about
        self._place = part.nodes, part._direction, part._guide
        self._stiffness, self._damping = stiffness, damping

    def add(self, state: State) -> None:
        """Add the forces of a step from a state without forces."""
        motion, loads = (state.omega, state.moment) if self.about else (state.v, state.f)
        step.linear_step(
            state.x, state.v, motion, state.dt, *self._place, self._stiffness, self._damping, loads
        )


@cache
def _compiled(kernel: Callable[..., None], law: Callable[..., float]) -> Callable[..., None]:
    """A kernel of the element for one law."""
    return specialise(kernel, law=law)
