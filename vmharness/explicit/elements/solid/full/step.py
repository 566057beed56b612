"""One step of many fully integrated solids: motion, then strain, stress and force point by point.

Arrays per block of LANES elements as those of the one-point solid (one_point/step.py), but `stress (blocks, 8, 6
rows)` and `history (blocks, 8, rows)`; in `kept` the hourglass forces are zero.
"""

from typing import Any

import numpy as np

from vmharness.explicit.elements.solid._gradient import at_point, mean, velocity_gradient
from vmharness.explicit.elements.solid._motion import at_mid_step, motion
from vmharness.explicit.elements.solid._pattern import nodal
from vmharness.explicit.elements.solid._rows import (
    FORCES,
    GRADIENT,
    MIDDLE,
    NOW,
    PRESSURE,
    STEP,
    STRAIN,
    TENSION,
    VOLUME,
    WORK,
    F,
    V,
    X,
    load_patterns,
    load_tensor,
    store_nodes,
    store_patterns,
)
from vmharness.explicit.elements.solid._viscosity import stable_step, viscosity
from vmharness.explicit.kernels.compiled import kernel, to_be_bound
from vmharness.explicit.kernels.rotation import matvec, strain_in_frame, stress_in_space
from vmharness.explicit.kernels.simd import LANES, gather, put, scatter, vector
from vmharness.explicit.kernels.vector import add, scale, subtract
from vmharness.explicit.state import Array, Index

stress_at_point = to_be_bound("stress_at_point")

POINTS = 8
G = 1 / 3**0.5  # Gauss's place in -1..1; all weights are 1


@kernel
def clear_forces(work: Array) -> None:
    """FORCES = 0, TENSION = 0."""
    for row in range(FORCES, TENSION + 1):
        for e in range(LANES):
            work[row * LANES + e] = 0.0


@kernel
def strain_at_point(work: Array, dt: float, xi: float, eta: float, zeta: float) -> None:
    """STRAIN = dt D with the mean dilatation, VOLUME = j, at mid-step."""
    for e in range(LANES):
        x, v = load_patterns(work, X, e), load_patterns(work, V, e)
        j, b = at_point(at_mid_step(x, v, dt), xi, eta, zeta)
        L, mean_L = velocity_gradient(v, j, b), load_tensor(work, GRADIENT, e)
        missing = (mean_L[0][0] + mean_L[1][1] + mean_L[2][2] - L[0][0] - L[1][1] - L[2][2]) / 3
        normal, shear = strain_in_frame(load_tensor(work, MIDDLE, e), L)
        put(work, STRAIN, e, scale(dt, add(normal, (missing, missing, missing))))
        put(work, STRAIN + 3, e, scale(dt, shear))
        work[VOLUME * LANES + e] = j


@kernel
def force_at_point(work: Array, stress: Array, xi: float, eta: float, zeta: float) -> None:
    """FORCES += s' b_k with the deviator s', TENSION += j tr s / 3, on the geometry at the end of the step."""
    for e in range(LANES):
        j, b = at_point(load_patterns(work, X, e), xi, eta, zeta)
        normal, shear = vector(stress, 0, e), vector(stress, 3, e)
        p = (normal[0] + normal[1] + normal[2]) / 3
        s = stress_in_space(load_tensor(work, NOW, e), subtract(normal, (p, p, p)), shear)
        f = load_patterns(work, FORCES, e)
        f = (
            add(f[0], matvec(s, b[0])),
            add(f[1], matvec(s, b[1])),
            add(f[2], matvec(s, b[2])),
            add(f[3], matvec(s, b[3])),
            add(f[4], matvec(s, b[4])),
            add(f[5], matvec(s, b[5])),
            add(f[6], matvec(s, b[6])),
        )
        store_patterns(work, FORCES, e, f)
        work[TENSION * LANES + e] += j * p


@kernel
def force(work: Array) -> None:
    """Nodal forces: those of the deviators, and (p - q) int b_k of the mean stress p less bulk viscosity q."""
    for e in range(LANES):
        volume, b = mean(load_patterns(work, X, e))
        p = work[TENSION * LANES + e] / volume - work[PRESSURE * LANES + e]
        f = load_patterns(work, FORCES, e)
        f = (
            add(f[0], scale(p, b[0])),
            add(f[1], scale(p, b[1])),
            add(f[2], scale(p, b[2])),
            add(f[3], scale(p, b[3])),
            add(f[4], scale(p, b[4])),
            add(f[5], scale(p, b[5])),
            f[6],
        )
        store_nodes(work, F, e, nodal(f))


def step(
    # state
    x: Array,
    v: Array,
    dt: float,
    # elements
    nodes: Index,
    elements: int,
    fixed: Array,
    # formulation and material
    modulus: float,
    viscous: tuple[float, float],
    hourglass: tuple[bool, bool],
    constants: Any,
    # elements, in and out
    kept: Array,
    stress: Array,
    history: Array,
    # out
    f: Array,
    energy: Array,
    # buffer
    work: Array,
) -> float:
    """Bring stresses to t_n, add forces and the work of the step; return the shortest stable step.

    `x`, `v`, `f` (n, 3); `modulus`: rho c^2; `viscous`: Q1, Q2; `hourglass` is not used.
    """
    q1, q2 = viscous
    for e in range(LANES):
        work[STEP * LANES + e] = np.inf
    for block in range(len(nodes)):
        gather(x, nodes[block], work, X)
        gather(v, nodes[block], work, V)
        motion(work, dt, kept[block])
        viscosity(work, dt, fixed[block], modulus, q1, q2, kept[block])
        stable_step(work, fixed[block], q1, q2)
        clear_forces(work)
        for p in range(POINTS):
            xi, eta, zeta = (2 * (p & 1) - 1) * G, ((p & 2) - 1) * G, ((p & 4) // 2 - 1) * G
            strain_at_point(work, dt, xi, eta, zeta)
            stress_at_point(work, dt, constants, stress[block, p], history[block, p])
            force_at_point(work, stress[block, p], xi, eta, zeta)
        force(work)
        count = min(LANES, elements - block * LANES)
        scatter(f, nodes[block], count, work, F)
        for e in range(count):
            energy[0] += work[WORK * LANES + e]
    shortest = np.inf
    for e in range(LANES):
        shortest = min(shortest, work[STEP * LANES + e])
    return shortest
