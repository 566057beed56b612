"""Rows of a block of shells in the buffer of kernels/simd.py, which has room for four nodes."""

from vmharness.explicit.kernels.simd import LANES, put
from vmharness.explicit.kernels.vector import Vector, inlined
from vmharness.explicit.state import Array

# Rows of nodes hold node 1 x, y, z, node 2 x, y, z, ...; the others have up to three components.
X, V, OMEGA = 0, 12, 24
F, MOMENT = V, OMEGA  # forces overwrite velocities, which are not needed then
MEMBRANE, CURVATURE, SHEAR = 36, 39, 42
N, M, S = 45, 48, 51
Q, R = 54, 57
AREA, WORK, HOURGLASS_WORK, LENGTH, THINNING = 60, 61, 62, 63, 64
ROWS = 65

# Rows of `section`; the hourglass moduli are the last.
THICKNESS, DENSITY_ROOT, MODULI = 0, 1, 2


@inlined
def put_strain(work: Array, e: int, area: float, membrane: Vector, curvature: Vector, shear: Vector) -> None:
    """Store area and strain increments of a step, and set resultants and work to zero."""
    put(work, MEMBRANE, e, membrane)
    put(work, CURVATURE, e, curvature)
    put(work, SHEAR, e, shear)
    put(work, N, e, (0.0, 0.0, 0.0))
    put(work, M, e, (0.0, 0.0, 0.0))
    put(work, S, e, (0.0, 0.0, 0.0))
    work[AREA * LANES + e] = area
    work[WORK * LANES + e] = 0.0
    work[HOURGLASS_WORK * LANES + e] = 0.0
    work[THINNING * LANES + e] = 0.0
