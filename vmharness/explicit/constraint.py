"""A constraint rules the motion of nodes: supports, prescribed motion, rigid bodies, rigid walls."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.model.state import Array, State


class Constraint(Protocol):
    """What the time loop asks of a constraint.

    `energy` holds the work that it does on the nodes, as "external work", where it moves them.
    """

    name: str
    energy: dict[str, Array]
    fixed: NDArray[np.bool_]  # (n, 6) degrees of freedom that need no mass, since the constraint moves them

    def accelerate(self, state: State) -> None:
        """Change `state.a` and `state.alpha` at t_n so that the constraint holds; keep the reaction."""

    def move(self, state: State, dt: float) -> None:
        """Change `state.v` and `state.omega` at t_{n+1/2}, for the step `dt` that follows."""
