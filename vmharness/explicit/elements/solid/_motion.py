"""First stages of a hexahedron's step: patterns, mean velocity gradient, rotating frame, mean strain.

x_{n-1/2} = x_n - dt/2 v_{n-1/2}, of patterns as of nodes. The frame rotates with the mean spin (kernels/rotation.py).
Each of the loops vectorises; in one loop they would not.
"""

from vmharness.explicit.elements.solid._gradient import mean, mean_velocity_gradient
from vmharness.explicit.elements.solid._pattern import Patterns, patterns
from vmharness.explicit.elements.solid._rows import (
    GRADIENT,
    MIDDLE,
    NOW,
    ROTATION,
    STRAIN,
    VOLUME,
    WORK,
    V,
    X,
    load_nodes,
    load_patterns,
    load_tensor,
    store_patterns,
    store_tensor,
)
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import (
    half_rotation,
    rotate_quaternion,
    rotation_matrix,
    strain_in_frame,
)
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import add, inlined, scale
from vmharness.explicit.state import Array


@inlined
def at_mid_step(x: Patterns, v: Patterns, dt: float) -> Patterns:
    """x - dt/2 v."""
    h = -0.5 * dt
    return (
        add(x[0], scale(h, v[0])),
        add(x[1], scale(h, v[1])),
        add(x[2], scale(h, v[2])),
        add(x[3], scale(h, v[3])),
        add(x[4], scale(h, v[4])),
        add(x[5], scale(h, v[5])),
        add(x[6], scale(h, v[6])),
    )


@kernel
def motion(work: Array, dt: float, kept: Array) -> None:
    """Patterns in place of nodes, GRADIENT, VOLUME, the frame in MIDDLE and NOW; work begins at zero."""
    to_patterns(work, X)
    to_patterns(work, V)
    gradient(work, dt)
    rotate_frame(work, dt, kept)


@kernel
def to_patterns(work: Array, row: int) -> None:
    """Patterns 1 to 7 in place of the nodes from `row` on."""
    for e in range(LANES):
        store_patterns(work, row, e, patterns(load_nodes(work, row, e)))


@kernel
def gradient(work: Array, dt: float) -> None:
    """VOLUME and GRADIENT at mid-step."""
    for e in range(LANES):
        v = load_patterns(work, V, e)
        volume, b = mean(at_mid_step(load_patterns(work, X, e), v, dt))
        store_tensor(work, GRADIENT, e, mean_velocity_gradient(v, volume, b))
        work[VOLUME * LANES + e] = volume
        work[WORK * LANES + e] = 0.0


@kernel
def rotate_frame(work: Array, dt: float, kept: Array) -> None:
    """Rotate the frame by the mean spin: its axes at mid-step in MIDDLE, at the end of the step in NOW."""
    for e in range(LANES):
        L = load_tensor(work, GRADIENT, e)
        spin = (L[2][1] - L[1][2], L[0][2] - L[2][0], L[1][0] - L[0][1])
        t = half_rotation(scale(0.25 * dt, spin))
        s, u = rotate_quaternion(kept[ROTATION * LANES + e], vector(kept, ROTATION + 1, e), t)
        store_tensor(work, MIDDLE, e, rotation_matrix(s, u))
        s, u = rotate_quaternion(s, u, t)
        store_tensor(work, NOW, e, rotation_matrix(s, u))
        kept[ROTATION * LANES + e] = s
        put(kept, ROTATION + 1, e, u)


@kernel
def mean_strain(work: Array, dt: float) -> None:
    """STRAIN = dt D of the mean velocity gradient."""
    for e in range(LANES):
        normal, shear = strain_in_frame(load_tensor(work, MIDDLE, e), load_tensor(work, GRADIENT, e))
        put(work, STRAIN, e, scale(dt, normal))
        put(work, STRAIN + 3, e, scale(dt, shear))
