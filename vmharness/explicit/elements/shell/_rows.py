"""The rows of a block of shells in the buffer of explicit/kernels/simd.py, with room for four nodes."""

from vmharness.explicit.kernels.simd import LANES, put
from vmharness.explicit.kernels.vector import Vector, inlined
from vmharness.explicit.model.state import Array

# The nodes' rows hold node 1 x, y, z, node 2 x, y, z, ...; the others up to three components each.
X, V, OMEGA = 0, 12, 24
F, MOMENT = V, OMEGA  # forces take the place of velocities, which are then used up
MEMBRANE, CURVATURE, SHEAR = 36, 39, 42
N, M, S = 45, 48, 51
Q, R = 54, 57
AREA, WORK, HOURGLASS_WORK, LENGTH, THINNING = 60, 61, 62, 63, 64
ROWS = 65

# Rows of an element's section; hourglass moduli follow.
THICKNESS, DENSITY_ROOT, MODULI = 0, 1, 2


@inlined
def put_strain(work: Array, e: int, area: float, membrane: Vector, curvature: Vector, shear: Vector) -> None:
    """Store the area and the increments of a step, whose resultants and work begin at zero."""
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
