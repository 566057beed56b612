"""Stiffness of a touch.

    SOFT 0   k = min(k_segment, k_node)                       (PENOPT 1)
    SOFT 1   k = max(that, SOFSCL m* / dt^2)                  m* the least mass of the node and the segment's nodes

`k_segment` and `k_node` carry SLSFAC and SFSA or SFSB. SOFT 1 is our reading of LSTC's FAQ contact.soft1, which has a
stiffness from nodal masses and the time step, with the least of the masses. dt is the longest step so far: with a step
that shrinks, the stiffness stays, and no energy is made. Nodes of rigid bodies count with their shares of the mass;
nodes without mass are held by something that is no rigid body: they set none.
"""

import numpy as np

from vmharness.explicit.contact.records import Record
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.state import Array


@inlined
def stiffness(node: Record, segment: Record, mass: Array, sofscl: float, longest: float) -> float:
    """k of a node on a segment; `sofscl` is zero for SOFT 0."""
    k = min(node["penalty"], segment["penalty"])
    if sofscl > 0.0 and longest > 0.0:
        least = np.inf
        for i in range(5):
            m = mass[node["row"]] if i == 4 else mass[segment["nodes"][i]]
            least = min(least, m if m > 0.0 else np.inf)
        if least < np.inf:
            k = max(k, sofscl * least / longest**2)
    return float(k)
