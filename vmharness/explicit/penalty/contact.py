"""The force of a contact: one or two passes of nodes against segments."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.penalty.options import Options
from vmharness.explicit.penalty.segments import Segments
from vmharness.explicit.penalty.tracked import Tracked
from vmharness.explicit.state import Array, State


class Contact:
    """A penalty contact: (tracked A, segments B), and for a two-way contact also (tracked B, segments A)."""

    def __init__(self, number: int, passes: Sequence[tuple[Tracked, Segments]], options: Options) -> None:
        """`number` is CID, or the contact's place in the deck."""
        self.number, self.name = number, f"contact {number}"
        self.tracked: NDArray[np.intp]  # (nt,) rows of the nodes of all passes
        self.segments: NDArray[np.intp]  # (ns, 4) of all passes
        self.force = np.zeros(3)  # resultant on surface A
        self.forces: Array  # (nt, 3) on the tracked nodes
        self.energy = {"contact": np.zeros(1), "friction": np.zeros(1)}

    def add(self, state: State) -> None:
        """Add the forces at t_n, and the work of the step that led to it."""

    def stable_step(self) -> float:
        """A penalty sets no step."""
        return np.inf

    def initial_penetrations(self, x: Array) -> list[tuple[int, Array]]:
        """Nodes that begin deeper than round-off: (row, the displacement (3,) that brings it to the surface)."""
        raise NotImplementedError

    def area(self) -> float:
        """Sum of the areas of the tracked nodes that are in contact."""
        raise NotImplementedError

    def touching(self) -> int:
        """How many tracked nodes are in contact."""
        raise NotImplementedError
