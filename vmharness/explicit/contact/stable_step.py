"""The step that the stiffness of a contact allows.

    dt <= 2 / omega      omega^2 = k (1/m_node + 1/m_segment)

for a node at the corner of a segment, the lightest that is not held; a node or corner that is held has infinite mass.
As in LS-DYNA the step is not shortened for it; a fact of the run reports where it is exceeded. Taken over all nodes
and segments, not pairs,

    omega^2 <= max k_node / m_node + max k_segment / m_segment

which is at most twice too large where the two belong to different places. With SOFT = 1 the stiffness follows the step.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.contact import OneWay
from vmharness.explicit.state import Array


def longest_step(one: OneWay, mass: Array, held: NDArray[np.bool_]) -> float:
    """The longest stable step of a pass; `held` (n,) nodes do not move. Infinite where no node does."""
    inverse = np.divide(1.0, mass, out=np.zeros_like(mass), where=(mass > 0.0) & ~held)
    k_node = np.minimum(one.nodes["penalty"], one.segments["penalty"].max(initial=0.0))
    at_nodes = (k_node * inverse[one.nodes["row"]]).max(initial=0.0)
    at_segments = (one.segments["penalty"] * inverse[one.segments["nodes"]].max(axis=1)).max(initial=0.0)
    square = at_nodes + at_segments
    return float(2.0 / np.sqrt(square)) if square > 0.0 else np.inf
