"""Strains and nodal forces of many triangles: the stages of shell/_step.py."""

from vmharness.explicit.elements.shell._rows import (
    DENSITY_ROOT,
    LENGTH,
    MOMENT,
    OMEGA,
    F,
    M,
    N,
    S,
    V,
    X,
    put_strain,
)
from vmharness.explicit.elements.shell.c0_triangle.frame import load_corners, store_corners
from vmharness.explicit.elements.shell.c0_triangle.strain import increments, nodal_forces
from vmharness.explicit.kernels.compiled import kernel, to_be_bound
from vmharness.explicit.kernels.simd import LANES, vector
from vmharness.explicit.kernels.vector import add, scale
from vmharness.explicit.state import Array

length = to_be_bound("length")  # the characteristic length by ISDO: see length.py


@kernel
def strain(work: Array, dt: float) -> None:
    """Rates on the geometry at mid-step, x_{n-1/2} = x_n - dt/2 v_{n-1/2}."""
    for e in range(LANES):
        x, v = load_corners(work, X, e), load_corners(work, V, e)
        half = -0.5 * dt
        middle = (add(x[0], scale(half, v[0])), add(x[1], scale(half, v[1])), add(x[2], scale(half, v[2])))
        area, membrane, curvature, shear = increments(middle, v, load_corners(work, OMEGA, e), dt)
        put_strain(work, e, area, membrane, curvature, shear)


@kernel
def no_hourglass(work: Array, dt: float, section: Array, viscous: bool, hourglass: Array) -> None:
    """Do nothing: three nodes have no hourglass pattern."""


def force(work: Array, section: Array) -> None:
    """Forces on the geometry at the end of the step, and the shortest characteristic length so far.

    Mass scaling slows the waves of an element, which has the same effect as a longer element.
    """
    for e in range(LANES):
        x = load_corners(work, X, e)
        scaled = section[DENSITY_ROOT * LANES + e] * length(x)
        work[LENGTH * LANES + e] = min(work[LENGTH * LANES + e], scaled)
        f, moment = nodal_forces(x, vector(work, N, e), vector(work, M, e), vector(work, S, e))
        store_corners(work, F, e, f)
        store_corners(work, MOMENT, e, moment)
