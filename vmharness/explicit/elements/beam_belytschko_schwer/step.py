"""One step of many beams: turn the vectors at the ends, measure the deformation, add forces and moments.

With the energy U of the deformations, g = dU/dr and the outer normal part taken off since r stays a unit vector,

    f_2 = dU/dL r + (g - (g . r) r) / L = -f_1

and a node that turns by the small rotation w changes s by w x s, so that dU/d(r . t) enters its moment as t x r.
The nodes feel the opposite. The resultants on the cross-section whose outer normal is r follow from the same terms.
"""

from math import asin, tan

from vmharness.explicit.compiled import kernel
from vmharness.explicit.elements.beam_belytschko_schwer.stiffness import (
    AXIAL,
    S_FAR,
    S_NEAR,
    T_FAR,
    T_NEAR,
    TORSION,
)
from vmharness.explicit.lanes import Indices
from vmharness.explicit.state import Array
from vmharness.explicit.vector import Vector, add, cross, dot, inlined, scale, subtract

# Resultants of an element: axial force, torque, moments of the ends on the beam about s, about t, per rotation.
FORCE, TORQUE, S_1, S_2, T_1, T_2 = range(6)


@inlined
def half_tangent(rotation: Vector) -> Vector:
    """p = tan(|rotation| / 2) along the axis of a rotation vector."""
    angle = dot(rotation, rotation) ** 0.5
    return scale(tan(0.5 * angle) / angle if angle > 0.0 else 0.5, rotation)


@inlined
def turned(a: Vector, p: Vector) -> Vector:
    """The vector `a` after the finite rotation p: a + 2/(1 + p.p) p x (a + p x a) keeps its length to round-off."""
    return add(a, scale(2 / (1 + dot(p, p)), cross(p, add(a, cross(p, a)))))


@inlined
def row(a: Array, i: int) -> Vector:
    """Row i of an array (n, 3)."""
    return a[i, 0], a[i, 1], a[i, 2]


@inlined
def put(a: Array, i: int, b: Vector) -> None:
    """Store row i of an array (n, 3)."""
    a[i, 0], a[i, 1], a[i, 2] = b


@inlined
def pull(a: Array, i: int, b: Vector) -> None:
    """Subtract from row i of an array (n, 3)."""
    a[i, 0] -= b[0]
    a[i, 1] -= b[1]
    a[i, 2] -= b[2]


@inlined
def slope(u: float) -> float:
    """d asin(u) / du."""
    return 1 / (1 - u * u) ** 0.5


@kernel
def turn(triads: Array, nodes: Indices, omega: Array, dt: float) -> None:
    """Turn s and t of both ends by their nodes' rotation over the step."""
    for e in range(len(nodes)):
        for end in range(2):
            p = half_tangent(scale(dt, row(omega, nodes[e, end])))
            for k in range(2):
                put(triads[e, end], k, turned(row(triads[e, end], k), p))


@kernel
def step(
    x: Array,
    nodes: Indices,
    length: Array,
    stiffness: Array,
    triads: Array,
    resultants: Array,
    f: Array,
    moment: Array,
    energy: Array,
) -> float:
    """Add forces and moments, set resultants and the `energy` (1,) stored; the smallest L / L_0, at most 1.

    `x`, `f`, `moment` (n, 3); `nodes (ne, 2)`; `length (ne,)` L_0; `stiffness (ne, 6)`, see stiffness.py;
    `triads (ne, 2, 2, 3)`: s and t at each end; `resultants (ne, 6)`.
    """
    smallest, twice = 1.0, 0.0
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
        smallest = min(smallest, L / length[e])

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

        g_1 = subtract(scale(R[S_1] * slope(u_s1), t1), scale(R[T_1] * slope(u_t1), s1))
        g_2 = subtract(scale(R[S_2] * slope(u_s2), t2), scale(R[T_2] * slope(u_t2), s2))
        g = add(g_1, g_2)
        force = add(scale(R[FORCE] - dot(g, r) / L, r), scale(1 / L, g))
        pull(f, j, force)
        pull(f, i, scale(-1.0, force))

        torque = scale(0.5 * R[TORQUE] * slope(u_r), subtract(cross(s2, t1), cross(t2, s1)))
        pull(moment, i, subtract(cross(g_1, r), torque))
        pull(moment, j, add(cross(g_2, r), torque))
    energy[0] = 0.5 * twice
    return smallest
