"""What can be touched: segments of shells or solids."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.model.state import Array


@dataclass(frozen=True)
class Segments:
    """Quadrilaterals and triangles of a contact surface; their normal points to the front by the right-hand rule."""

    nodes: NDArray[np.intp]  # (ns, 4) rows of the state's arrays; a triangle repeats its third node
    penalty: Array  # (ns,) stiffness, SLSFAC SFSB K A/d of a shell or SLSFAC SFSB K A^2/V of a solid
    thickness: Array  # (ns,) of the shell; zero for solids, and where mid-surfaces touch
    release: Array  # (ns,) depth beyond which a node is let go; infinity where none is
    two_sided: NDArray[
        np.bool_
    ]  # (ns,) touched from the side that a node comes from; else from the front alone
