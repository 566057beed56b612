"""Interfaces of forces: whatever adds force and moment to nodes, such as elements, contacts, loads and damping."""

import copy
from collections.abc import Callable
from typing import Any, Protocol, TypeVar, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.state import Array, Index, State


class Force(Protocol):
    """Interface of a force to the time loop.

    `energy` maps names of energies ("internal", "hourglass", "contact", "external work", ...) to arrays of one number
    that `add` brings up to date. Work over a step is 1/2 (f_n + f_{n+1}) . dt v_{n+1/2}.
    """

    name: str
    energy: dict[str, Array]

    def add(self, state: State) -> None:
        """Add force and moment at t_n to `state.f` and `state.moment`, and the work of the step that led to t_n."""


@runtime_checkable
class Elements(Force, Protocol):
    """A force that is the elements of one kind in one part; these alone set the time step."""

    kind: str  # "shell", "solid", "beam", "discrete"
    pid: int | None  # of the part
    eid: NDArray[np.int64]  # (ne,) numbers of the elements
    nodes: Index  # (ne, corners) rows of the state's arrays; -1 is the ground

    def stable_step(self) -> float:
        """The largest stable time step at the geometry of the last `add`; infinity where none is set."""

    def linearised(self) -> Force:
        """A copy of elastic elements without stress, for the highest frequency: timestep/highest_mode.py.

        After a small step dt of velocity v its force is f_0 - (K dt + 2 C) v, with the largest stiffness K that the law
        can have, and the damping C that lags half a step.
        """

    def probe(self, element: int, point: int, component: str) -> Callable[[], float]:
        """What shows a component, such as `xx-stress`, of an element (its place in `eid`); points count from 1.

        Raises ValueError, which lists the components, for one that there is not.
        """


@runtime_checkable
class Scalable(Elements, Protocol):
    """Elements whose density can be raised, each by its own factor.

    All nodes of an element take the same share of its mass and rotary inertia.
    """

    mass: Array  # (ne,) that each node takes, at the material's density
    inertia: Array  # (ne,)

    def steps(self, x: Array) -> Array:
        """The stable step (ne,) of each element at coordinates `x` (n, 3) and its density."""

    def scale_density(self, factor: Array) -> None:
        """Raise the densities by `factor` (ne,): from the next `add` on, steps are sqrt(factor) times as long."""


@runtime_checkable
class Dampable(Elements, Protocol):
    """Elements with stiffness damping: damping/stiffness.py."""

    def steps(self, x: Array) -> Array:
        """The stable step (ne,) of each element at coordinates `x` (n, 3), undamped."""

    def damp(self, beta: Array) -> None:
        """Add to the stress of the law `beta` (ne,) times its rate; call it before the first step."""


Copied = TypeVar("Copied", bound=Force)


def copy_of(force: Copied) -> Copied:
    """A copy with arrays of its own; kernels and constants of materials are shared."""
    made = copy.copy(force)
    made.__dict__.update({name: _own(value) for name, value in vars(force).items()})
    return made


def _own(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.copy()
    if type(value) is dict:
        return {name: _own(one) for name, one in value.items()}
    return tuple(map(_own, value)) if type(value) is tuple else value
