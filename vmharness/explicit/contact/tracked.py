"""What touches: nodes, each with the stiffness, thickness and area of its own elements."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.model.state import Array


@dataclass(frozen=True)
class Tracked:
    """Nodes that are kept from passing through segments."""

    nodes: NDArray[np.intp]  # (nt,) rows of the state's arrays, each once
    penalty: Array  # (nt,) SLSFAC SFSA times the largest of the node's elements; infinity where it has none
    thickness: Array  # (nt,) of its shells; zero where it has none, and where mid-surfaces touch
    area: Array  # (nt,) its share of the surface, for VC; infinity where it has none
