"""Rows of a block of hexahedra in the buffer of kernels/simd.py, and of the arrays that are kept between steps."""

from vmharness.explicit.elements.solid._pattern import Nodes, Patterns
from vmharness.explicit.kernels.rotation import Triad
from vmharness.explicit.kernels.simd import put, vector
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.state import Array

# The buffer. X and V hold nodes first, then patterns 1 to 7; forces overwrite velocities, which are not needed then.
X, V = 0, 24
F = V
GRADIENT = 48  # mean velocity gradient at mid-step
MIDDLE, NOW = 57, 66  # axes of the frame at mid-step and at its end
STRAIN = 75  # increments 11, 22, 33, 12, 23, 31 in the frame (engineering shears)
HOURGLASS = 81  # rates, then forces, of patterns 4 to 7
VOLUME = 93  # of the element, or of one of its points, at mid-step
PRESSURE = 94  # bulk viscosity
WORK, HOURGLASS_WORK, STEP = 95, 96, 97
FORCES, TENSION = (
    98,
    119,
)  # of a fully integrated element: on patterns 1 to 7 by deviators; V times mean stress
ROWS = 120

# Rows of `kept`: quaternion of the frame, bulk viscosity, hourglass forces of patterns 4 to 7 in the frame.
ROTATION, VISCOSITY, RESISTANCE = 0, 4, 5
KEPT = 17

MASS, MODULUS, SPEED = 0, 1, 2  # rows of `fixed`; the last is the wave speed c


@inlined
def load_nodes(work: Array, row: int, e: int) -> Nodes:
    """The vectors at the eight nodes of element e."""
    return (
        vector(work, row, e),
        vector(work, row + 3, e),
        vector(work, row + 6, e),
        vector(work, row + 9, e),
        vector(work, row + 12, e),
        vector(work, row + 15, e),
        vector(work, row + 18, e),
        vector(work, row + 21, e),
    )


@inlined
def store_nodes(work: Array, row: int, e: int, a: Nodes) -> None:
    """Store the vectors at the eight nodes of element e."""
    put(work, row, e, a[0])
    put(work, row + 3, e, a[1])
    put(work, row + 6, e, a[2])
    put(work, row + 9, e, a[3])
    put(work, row + 12, e, a[4])
    put(work, row + 15, e, a[5])
    put(work, row + 18, e, a[6])
    put(work, row + 21, e, a[7])


@inlined
def load_patterns(work: Array, row: int, e: int) -> Patterns:
    """Patterns 1 to 7 of element e."""
    return (
        vector(work, row, e),
        vector(work, row + 3, e),
        vector(work, row + 6, e),
        vector(work, row + 9, e),
        vector(work, row + 12, e),
        vector(work, row + 15, e),
        vector(work, row + 18, e),
    )


@inlined
def store_patterns(work: Array, row: int, e: int, a: Patterns) -> None:
    """Store patterns 1 to 7 of element e."""
    put(work, row, e, a[0])
    put(work, row + 3, e, a[1])
    put(work, row + 6, e, a[2])
    put(work, row + 9, e, a[3])
    put(work, row + 12, e, a[4])
    put(work, row + 15, e, a[5])
    put(work, row + 18, e, a[6])


@inlined
def load_tensor(work: Array, row: int, e: int) -> Triad:
    """Nine rows of element e."""
    return vector(work, row, e), vector(work, row + 3, e), vector(work, row + 6, e)


@inlined
def store_tensor(work: Array, row: int, e: int, a: Triad) -> None:
    """Store nine rows of element e."""
    put(work, row, e, a[0])
    put(work, row + 3, e, a[1])
    put(work, row + 6, e, a[2])
