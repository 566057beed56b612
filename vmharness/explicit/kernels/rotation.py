"""A frame that turns with an element, kept as a unit quaternion; for many elements at once.

A quaternion (s, u) is a rotation by the angle theta about u: s = cos(theta/2), |u| = sin(theta/2). In one step the
frame turns by the spin at mid-step, with the Rodrigues vector (Hughes and Winget 1980)

    t = dt/4 curl v,   |t| = tan(theta/2)

The chord velocity of a rigid rotation by theta has just this t on the mid-step geometry, so that finite rotations are
exact. Stress kept in this frame, with strain increments turned by half the step's rotation, obeys the Jaumann rate to
second order in dt:

    ds/dt = C D + W s - s W

Source: T. J. R. Hughes, J. Winget, Finite rotation effects in numerical integration of rate constitutive equations
arising in large-deformation analysis, International Journal for Numerical Methods in Engineering 15 (1980) 1862-1867.
"""

from vmharness.explicit.kernels.vector import Vector, add, combine, cross, dot, inlined, scale

Triad = tuple[Vector, Vector, Vector]


@inlined
def half(t: Vector) -> Vector:
    """The Rodrigues vector of half the rotation: tan(theta/4) from tan(theta/2)."""
    return scale(1 / (1 + (1 + dot(t, t)) ** 0.5), t)


@inlined
def turned(s: float, u: Vector, t: Vector) -> tuple[float, Vector]:
    """The quaternion (s, u) turned further by the Rodrigues vector t."""
    norm = 1 / (1 + dot(t, t)) ** 0.5
    return norm * (s - dot(t, u)), scale(norm, add(add(u, scale(s, t)), cross(t, u)))


@inlined
def triad(s: float, u: Vector) -> Triad:
    """The frame's axes e1, e2, e3 in space: the columns of the rotation matrix."""
    a, b, c = u
    return (
        (1 - 2 * (b * b + c * c), 2 * (a * b + s * c), 2 * (a * c - s * b)),
        (2 * (a * b - s * c), 1 - 2 * (a * a + c * c), 2 * (b * c + s * a)),
        (2 * (a * c + s * b), 2 * (b * c - s * a), 1 - 2 * (a * a + b * b)),
    )


@inlined
def apply(A: Triad, b: Vector) -> Vector:
    """A . b, where A holds the rows of a tensor."""
    return dot(A[0], b), dot(A[1], b), dot(A[2], b)


@inlined
def strain_in_frame(e: Triad, L: Triad) -> tuple[Vector, Vector]:
    """e_i . D e_j: the strains 11, 22, 33 and engineering shears 12, 23, 31 of the gradient L (its rows)."""
    L1, L2, L3 = apply(L, e[0]), apply(L, e[1]), apply(L, e[2])
    normal = (dot(e[0], L1), dot(e[1], L2), dot(e[2], L3))
    shear = (
        dot(e[0], L2) + dot(e[1], L1),
        dot(e[1], L3) + dot(e[2], L2),
        dot(e[2], L1) + dot(e[0], L3),
    )
    return normal, shear


@inlined
def stress_in_space(e: Triad, normal: Vector, shear: Vector) -> Triad:
    """The rows of sum s_ij e_i (x) e_j, from the stresses 11, 22, 33 and 12, 23, 31 in the frame."""
    columns = (
        combine(e, (normal[0], shear[0], shear[2])),
        combine(e, (shear[0], normal[1], shear[1])),
        combine(e, (shear[2], shear[1], normal[2])),
    )
    x, y, z = (e[0][0], e[1][0], e[2][0]), (e[0][1], e[1][1], e[2][1]), (e[0][2], e[1][2], e[2][2])
    return combine(columns, x), combine(columns, y), combine(columns, z)
