"""The rows of a block of shells in the buffer of explicit/lanes.py."""

from vmharness.explicit.elements.shell_belytschko_tsay.frame import Corners
from vmharness.explicit.lanes import put, vector
from vmharness.explicit.state import Array
from vmharness.explicit.vector import inlined

# Rows of the buffer. The nodes' rows hold node 1 x, y, z, node 2 x, y, z, ...; the others up to three components each.
X, V, OMEGA = 0, 12, 24
F, MOMENT = V, OMEGA  # forces take the place of velocities, which are then used up
MEMBRANE, CURVATURE, SHEAR = 36, 39, 42
N, M, S = 45, 48, 51
Q, R = 54, 57
AREA, WORK, HOURGLASS_WORK, LENGTH, THINNING = 60, 61, 62, 63, 64
ROWS = 65


@inlined
def corners(work: Array, row: int, e: int) -> Corners:
    """The vectors at the four nodes of element e."""
    return vector(work, row, e), vector(work, row + 3, e), vector(work, row + 6, e), vector(work, row + 9, e)


@inlined
def put_corners(work: Array, row: int, e: int, a: Corners) -> None:
    """Store the vectors at the four nodes of element e."""
    put(work, row, e, a[0])
    put(work, row + 3, e, a[1])
    put(work, row + 6, e, a[2])
    put(work, row + 9, e, a[3])
