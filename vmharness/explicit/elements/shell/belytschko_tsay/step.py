"""Strains, hourglass forces and nodal forces of many quadrilaterals: the stages of shell/_step.py.

The last rows of `section` are the three hourglass moduli; `hourglass (5 rows)` is Q x, y, z and R x, y.
"""

from vmharness.explicit.elements.shell._rows import (
    DENSITY_ROOT,
    HOURGLASS_WORK,
    LENGTH,
    MODULI,
    MOMENT,
    OMEGA,
    F,
    M,
    N,
    Q,
    R,
    S,
    V,
    X,
    put_strain,
)
from vmharness.explicit.elements.shell.belytschko_tsay.frame import load_corners, store_corners
from vmharness.explicit.elements.shell.belytschko_tsay.strain import increments, nodal_forces
from vmharness.explicit.kernels.compiled import kernel, to_be_bound
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import add, dot, scale
from vmharness.explicit.state import Array

length = to_be_bound("length")  # the characteristic length by ISDO: see length.py


@kernel
def strain(work: Array, dt: float) -> None:
    """Rates on the geometry at mid-step, x_{n-1/2} = x_n - dt/2 v_{n-1/2}."""
    for e in range(LANES):
        x, v = load_corners(work, X, e), load_corners(work, V, e)
        half = -0.5 * dt
        middle = (
            add(x[0], scale(half, v[0])),
            add(x[1], scale(half, v[1])),
            add(x[2], scale(half, v[2])),
            add(x[3], scale(half, v[3])),
        )
        area, membrane, curvature, shear, q, r = increments(middle, v, load_corners(work, OMEGA, e), dt)
        put_strain(work, e, area, membrane, curvature, shear)
        put(work, Q, e, q)
        put(work, R, e, r)


@kernel
def hourglass_force(work: Array, dt: float, section: Array, viscous: bool, hourglass: Array) -> None:
    """Hourglass forces Q += C q dt (stiffness) or Q = c q (viscous), and their work 1/2 (Q_{n-1} + Q_n) q dt."""
    memory, gain = (0.0, 1.0) if viscous else (1.0, dt)
    for e in range(LANES):
        membrane, warping, bending = vector(section, MODULI, e)
        q, r = vector(work, Q, e), vector(work, R, e)
        Q_past = vector(hourglass, 0, e)
        R_past = (hourglass[3 * LANES + e], hourglass[4 * LANES + e], 0.0)
        Q_now = add(scale(memory, Q_past), scale(gain, (membrane * q[0], membrane * q[1], warping * q[2])))
        R_now = add(scale(memory, R_past), scale(gain * bending, r))

        put(hourglass, 0, e, Q_now)
        hourglass[3 * LANES + e], hourglass[4 * LANES + e] = R_now[0], R_now[1]
        put(work, Q, e, Q_now)
        put(work, R, e, R_now)
        work[HOURGLASS_WORK * LANES + e] = (
            0.5 * dt * (dot(add(Q_past, Q_now), q) + dot(add(R_past, R_now), r))
        )


def force(work: Array, section: Array) -> None:
    """Forces on the geometry at the end of the step, and the shortest characteristic length so far.

    Mass scaling slows the waves of an element, which has the same effect as a longer element.
    """
    for e in range(LANES):
        x = load_corners(work, X, e)
        work[LENGTH * LANES + e] = min(
            work[LENGTH * LANES + e], section[DENSITY_ROOT * LANES + e] * length(x)
        )
        f, moment = nodal_forces(
            x,
            vector(work, N, e),
            vector(work, M, e),
            vector(work, S, e),
            vector(work, Q, e),
            vector(work, R, e),
        )
        store_corners(work, F, e, f)
        store_corners(work, MOMENT, e, moment)
