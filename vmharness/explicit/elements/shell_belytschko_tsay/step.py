"""One step of many shells: gather, rates at mid-step, stresses, forces at the end of the step, scatter.

Arrays per block of LANES elements, with rows as in lanes.py: `nodes (blocks, 4 rows)`; `section (blocks, 5 rows)`,
thickness, the three hourglass moduli, root of the factor of density (1 but for mass scaling); `stress (blocks, nip, 5
rows)`, xx, yy, xy, yz, zx; `history (blocks, nip, rows)`; `hourglass (blocks, 5 rows)`, Q x, y, z and R x, y. The last
block is filled up with copies of the last element, which add neither force nor energy.
"""

import numpy as np

from vmharness.explicit.compiled import kernel
from vmharness.explicit.elements.shell_belytschko_tsay.forces import nodal_forces
from vmharness.explicit.elements.shell_belytschko_tsay.lanes import (
    AREA,
    CURVATURE,
    HOURGLASS_WORK,
    LENGTH,
    MEMBRANE,
    MOMENT,
    OMEGA,
    SHEAR,
    THINNING,
    WORK,
    F,
    M,
    N,
    Q,
    R,
    S,
    V,
    X,
    corners,
    put_corners,
)
from vmharness.explicit.elements.shell_belytschko_tsay.length import by_side as length
from vmharness.explicit.elements.shell_belytschko_tsay.rates import increments
from vmharness.explicit.elements.shell_belytschko_tsay.thickness import thin
from vmharness.explicit.lanes import LANES, Indices, gather, put, scatter, vector
from vmharness.explicit.materials.elastic import plane_stress as law
from vmharness.explicit.state import Array
from vmharness.explicit.vector import add, dot, scale


@kernel
def strain(work: Array, dt: float) -> None:
    """Rates on the geometry at mid-step, x_{n-1/2} = x_n - dt/2 v_{n-1/2}; resultants and work begin at zero."""
    for e in range(LANES):
        x, v = corners(work, X, e), corners(work, V, e)
        half = -0.5 * dt
        middle = (
            add(x[0], scale(half, v[0])),
            add(x[1], scale(half, v[1])),
            add(x[2], scale(half, v[2])),
            add(x[3], scale(half, v[3])),
        )
        area, membrane, curvature, shear, q, r = increments(middle, v, corners(work, OMEGA, e), dt)
        put(work, MEMBRANE, e, membrane)
        put(work, CURVATURE, e, curvature)
        put(work, SHEAR, e, shear)
        put(work, Q, e, q)
        put(work, R, e, r)
        put(work, N, e, (0.0, 0.0, 0.0))
        put(work, M, e, (0.0, 0.0, 0.0))
        put(work, S, e, (0.0, 0.0, 0.0))
        work[AREA * LANES + e] = area
        work[WORK * LANES + e] = 0.0
        work[THINNING * LANES + e] = 0.0


def stress_at_point(
    work: Array,
    dt: float,
    section: Array,
    zeta: float,
    weight: float,
    shrf: float,
    constants: tuple[float, ...],
    stress: Array,
    history: Array,
) -> None:
    """Update the stress at height z = zeta t/2 and add its share to resultants and work, with dz = weight t/2.

    N = int s dz,   M = int z s dz,   S = kappa int s dz,   work = A int 1/2 (s_{n-1} + s_n) de dz
    and to the mean strain through the thickness, int de_zz dz / t.
    """
    for e in range(LANES):
        thickness = section[e]
        z, dz = 0.5 * thickness * zeta, 0.5 * thickness * weight
        membrane, curvature, shear = (
            vector(work, MEMBRANE, e),
            vector(work, CURVATURE, e),
            vector(work, SHEAR, e),
        )
        dexx, deyy, dexy = add(membrane, scale(z, curvature))
        deyz, dezx, _ = shear
        pxx, pyy, pxy = vector(stress, 0, e)
        pyz, pzx = stress[3 * LANES + e], stress[4 * LANES + e]

        sxx, syy, sxy, syz, szx, dezz = law(
            constants, dt, dexx, deyy, dexy, deyz, dezx, pxx, pyy, pxy, pyz, pzx, history, e, LANES
        )

        put(stress, 0, e, (sxx, syy, sxy))
        stress[3 * LANES + e], stress[4 * LANES + e] = syz, szx
        put(work, N, e, add(vector(work, N, e), scale(dz, (sxx, syy, sxy))))
        put(work, M, e, add(vector(work, M, e), scale(z * dz, (sxx, syy, sxy))))
        put(work, S, e, add(vector(work, S, e), scale(shrf * dz, (syz, szx, 0.0))))
        in_plane = (pxx + sxx) * dexx + (pyy + syy) * deyy + (pxy + sxy) * dexy
        across = (pyz + syz) * deyz + (pzx + szx) * dezx
        work[THINNING * LANES + e] += 0.5 * weight * dezz
        work[WORK * LANES + e] += 0.5 * dz * work[AREA * LANES + e] * (in_plane + shrf * across)


@kernel
def hourglass_force(work: Array, dt: float, section: Array, viscous: bool, hourglass: Array) -> None:
    """Hourglass forces Q += C q dt (stiffness) or Q = c q (viscous), and their work 1/2 (Q_{n-1} + Q_n) q dt."""
    memory, gain = (0.0, 1.0) if viscous else (1.0, dt)
    for e in range(LANES):
        membrane, warping, bending = vector(section, 1, e)
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

    Mass scaling slows the waves of an element, as if it were longer.
    """
    for e in range(LANES):
        x = corners(work, X, e)
        work[LENGTH * LANES + e] = min(work[LENGTH * LANES + e], section[4 * LANES + e] * length(x))
        f, moment = nodal_forces(
            x,
            vector(work, N, e),
            vector(work, M, e),
            vector(work, S, e),
            vector(work, Q, e),
            vector(work, R, e),
        )
        put_corners(work, F, e, f)
        put_corners(work, MOMENT, e, moment)


def step(
    x: Array,
    v: Array,
    omega: Array,
    dt: float,
    nodes: Indices,
    elements: int,
    section: Array,
    points: Array,
    shrf: float,
    thinning: bool,
    constants: tuple[float, ...],
    stress: Array,
    history: Array,
    viscous: bool,
    hourglass: Array,
    f: Array,
    moment: Array,
    energy: Array,
    work: Array,
) -> float:
    """Bring stresses to t_n, add forces and moments there, and the step's work to `energy`; the shortest L_s.

    `x`, `v`, `omega`, `f`, `moment` (n, 3); `points` (nip, 2): height -1..1 and weight of sum 2; `energy` (2,):
    internal, hourglass.
    """
    for e in range(LANES):
        work[LENGTH * LANES + e] = np.inf
    for block in range(len(nodes)):
        gather(x, nodes[block], work, X)
        gather(v, nodes[block], work, V)
        gather(omega, nodes[block], work, OMEGA)
        strain(work, dt)
        for p in range(len(points)):
            zeta, weight = points[p]
            stress_at_point(
                work, dt, section[block], zeta, weight, shrf, constants, stress[block, p], history[block, p]
            )
        if thinning:
            thin(work, section[block])
        hourglass_force(work, dt, section[block], viscous, hourglass[block])
        force(work, section[block])
        count = min(LANES, elements - block * LANES)
        scatter(f, nodes[block], count, work, F)
        scatter(moment, nodes[block], count, work, MOMENT)
        for e in range(count):
            energy[0] += work[WORK * LANES + e]
            energy[1] += work[HOURGLASS_WORK * LANES + e]
    shortest = np.inf
    for e in range(LANES):
        shortest = min(shortest, work[LENGTH * LANES + e])
    return shortest
