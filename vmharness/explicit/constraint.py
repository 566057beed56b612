"""A constraint determines or changes the motion of nodes: supports, motions, damping, rigid walls, rigid bodies."""

from collections.abc import Iterator
from typing import Protocol, runtime_checkable

from vmharness.explicit.state import Array, Flags, Index, State


class Constraint(Protocol):
    """What the time loop asks of a constraint.

    `energy` maps names of energies to arrays of one number: "external work", if the constraint moves nodes, "damping",
    "rigid wall".
    """

    name: str
    energy: dict[str, Array]
    fixed: Flags  # (n, 6) degrees of freedom that need no mass, since the constraint moves them

    def accelerate(self, state: State) -> None:
        """Change `state.a` and `state.alpha` at t_n so that the constraint holds, and store the reaction."""

    def move(self, state: State, dt: float) -> None:
        """Change `state.v` and `state.omega` at t_{n+1/2} so that the constraint holds after the next step `dt`."""


@runtime_checkable
class Binding(Constraint, Protocol):
    """A constraint by which nodes move together."""

    def modes(self, state: State, held: Flags) -> Iterator[tuple[Index, Array]]:
        """For each group of nodes (m,) its k free motions of unit mass, as velocities (m, 6, k) of the nodes.

        `held` (n, 6): degrees of freedom that constraints rule.
        """
