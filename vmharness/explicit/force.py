"""A force is anything that pushes on nodes: element blocks, contacts, loads, damping."""

from typing import Protocol

from vmharness.explicit.state import Array, State


class Force(Protocol):
    """What the time loop asks of a force.

    `energy` maps names of energies ("internal", "hourglass", "contact", "external work", ...) to arrays of one number
    that `add` brings up to date. Work over a step is 1/2 (f_n + f_{n+1}) . dt v_{n+1/2}.
    """

    name: str
    energy: dict[str, Array]

    def add(self, state: State) -> None:
        """Add force and moment at t_n to `state.f` and `state.moment`, and the work of the step that led to t_n."""

    def stable_step(self) -> float:
        """The largest stable time step at the geometry of the last `add`; infinity where none is set."""
