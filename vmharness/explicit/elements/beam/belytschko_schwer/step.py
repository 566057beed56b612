"""One step of many beams: rotate the vectors at the ends, measure the deformation, add forces and moments.

With the energy U of the deformations, g = dU/dr and the outer normal part taken off since r stays a unit vector,

    f_2 = dU/dL r + (g - (g . r) r) / L = -f_1

and a small rotation w of a node changes s by w x s, so that dU/d(r . t) enters its moment as t x r.
The nodes get the opposite of these internal forces. The resultants on the cross-section whose outer normal is r follow
from the same terms.

With stiffness damping (damping/stiffness.py) the resultants R = dU/d(deformation) become R + beta dR/dt.
"""

from math import asin, tan

import numpy as np

from vmharness.explicit.elements.beam.belytschko_schwer.stiffness import (
    AXIAL,
    S_FAR,
    S_NEAR,
    T_FAR,
    T_NEAR,
    TORSION,
)
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, row, scale, set_row, subtract
from vmharness.explicit.state import Array, Index

# Resultants of an element: axial force, torque, moments of the ends on the beam about s, about t, per rotation.
FORCE, TORQUE, S_1, S_2, T_1, T_2 = range(6)

# Rows that a damped element keeps: elastic resultants, those of damping, deformations.
ELASTIC, DRAG, DEFORMED = 0, 6, 12
KEPT = 18


@inlined
def half_tangent(rotation: Vector) -> Vector:
    """p = tan(|rotation| / 2) along the axis of a rotation vector."""
    angle = dot(rotation, rotation) ** 0.5
    return scale(tan(0.5 * angle) / angle if angle > 0.0 else 0.5, rotation)


@inlined
def rotated(a: Vector, p: Vector) -> Vector:
    """The vector `a` after the finite rotation p: a + 2/(1 + p.p) p x (a + p x a), of the same length to round-off."""
    return add(a, scale(2 / (1 + dot(p, p)), cross(p, add(a, cross(p, a)))))


@inlined
def subtract_row(a: Array, i: int, b: Vector) -> None:
    """Subtract from row i of an array (n, 3)."""
    a[i, 0] -= b[0]
    a[i, 1] -= b[1]
    a[i, 2] -= b[2]


@inlined
def slope(u: float) -> float:
    """d asin(u) / du."""
    return 1 / (1 - u * u) ** 0.5


@kernel
def rotate_triads(triads: Array, nodes: Index, omega: Array, dt: float) -> None:
    """Rotate s and t of both ends by the rotation of their nodes in the step."""
    for e in range(len(nodes)):
        for end in range(2):
            p = half_tangent(scale(dt, row(omega, nodes[e, end])))
            for k in range(2):
                set_row(triads[e, end], k, rotated(row(triads[e, end], k), p))


@inlined
def add_damping(
    R: Array, deformed: tuple[float, float, float, float, float, float], rate: float, kept: Array
) -> float:
    """R += rate (R_n - R_{n-1}), rate = beta/dt; return the work of the addition, 1/2 (old + new) . increments."""
    work = 0.0
    for m in range(6):
        drag = rate * (R[m] - kept[ELASTIC + m])
        work += 0.5 * (kept[DRAG + m] + drag) * (deformed[m] - kept[DEFORMED + m])
        kept[ELASTIC + m], kept[DRAG + m], kept[DEFORMED + m] = R[m], drag, deformed[m]
        R[m] += drag
    return work


@kernel
def step(
    # state
    x: Array,
    dt: float,
    # elements
    nodes: Index,
    length: Array,
    limit: Array,
    stiffness: Array,
    # elements, in and out
    triads: Array,
    resultants: Array,
    damping: tuple[Array, Array, Array] | None,
    # out
    f: Array,
    moment: Array,
    energy: Array,
) -> float:
    """Add forces and moments, set resultants and the `energy` (1,) stored and damped; return the shortest stable step.

    `x`, `f`, `moment` (n, 3); `nodes (ne, 2)`; `length (ne,)` L_0 and the `limit (ne,)` that goes with it; `stiffness
    (ne, 6)`, see stiffness.py; `triads (ne, 2, 2, 3)`: s and t at each end; `resultants (ne, 6)`; `damping`: beta
    (ne,), what is kept (ne, 18), the work lost so far (1,).
    """
    shortest, twice = np.inf, 0.0
    for e in range(len(nodes)):
        i, j = nodes[e, 0], nodes[e, 1]
        s1, t1, s2, t2 = (
            row(triads[e, 0], 0),
            row(triads[e, 0], 1),
            row(triads[e, 1], 0),
            row(triads[e, 1], 1),
        )
        d = subtract(row(x, j), row(x, i))
        L = dot(d, d) ** 0.5
        r = scale(1 / L, d)
        shortest = min(shortest, limit[e] * min(1.0, L / length[e]))

        u_s1, u_s2 = dot(r, t1), dot(r, t2)
        u_t1, u_t2 = -dot(r, s1), -dot(r, s2)
        u_r = 0.5 * (dot(s2, t1) - dot(t2, s1))
        elongation, phi = L - length[e], asin(u_r)
        theta_s1, theta_s2, theta_t1, theta_t2 = asin(u_s1), asin(u_s2), asin(u_t1), asin(u_t2)

        k, R = stiffness[e], resultants[e]
        R[FORCE], R[TORQUE] = k[AXIAL] * elongation, k[TORSION] * phi
        R[S_1] = k[S_NEAR] * theta_s1 + k[S_FAR] * theta_s2
        R[S_2] = k[S_FAR] * theta_s1 + k[S_NEAR] * theta_s2
        R[T_1] = k[T_NEAR] * theta_t1 + k[T_FAR] * theta_t2
        R[T_2] = k[T_FAR] * theta_t1 + k[T_NEAR] * theta_t2
        twice += R[FORCE] * elongation + R[TORQUE] * phi
        twice += R[S_1] * theta_s1 + R[S_2] * theta_s2 + R[T_1] * theta_t1 + R[T_2] * theta_t2

        if damping is not None:
            beta, kept, lost = damping
            deformed = (elongation, phi, theta_s1, theta_s2, theta_t1, theta_t2)
            lost[0] += add_damping(R, deformed, beta[e] / dt if dt > 0.0 else 0.0, kept[e])

        g_1 = subtract(scale(R[S_1] * slope(u_s1), t1), scale(R[T_1] * slope(u_t1), s1))
        g_2 = subtract(scale(R[S_2] * slope(u_s2), t2), scale(R[T_2] * slope(u_t2), s2))
        g = add(g_1, g_2)
        force = add(scale(R[FORCE] - dot(g, r) / L, r), scale(1 / L, g))
        subtract_row(f, j, force)
        subtract_row(f, i, scale(-1.0, force))

        torque = scale(0.5 * R[TORQUE] * slope(u_r), subtract(cross(s2, t1), cross(t2, s1)))
        subtract_row(moment, i, subtract(cross(g_1, r), torque))
        subtract_row(moment, j, add(cross(g_2, r), torque))
    energy[0] = 0.5 * twice
    if damping is not None:
        energy[0] += damping[2][0]
    return shortest
