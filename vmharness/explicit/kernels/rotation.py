"""Finite rotations: unit quaternions, Rodrigues vectors, rotation matrices, and tensors in a rotating frame.

A rotation by the angle theta about the unit vector n has

    rotation vector     w = theta n
    Rodrigues vector    t = tan(theta/2) n
    unit quaternion     (s, u),   s = cos(theta/2),   u = sin(theta/2) n

An element's frame rotates in one step by the spin at mid-step, with the Rodrigues vector (Hughes and Winget 1980)

    t = dt/4 curl v,   |t| = tan(theta/2)

The chord velocity of a rigid rotation by theta has exactly this t on the mid-step geometry, so that finite rotations
are exact. Stress kept in this frame, with strain increments rotated by half the step's rotation, obeys the Jaumann rate
to second order in dt:

    ds/dt = C D + W s - s W

Source: T. J. R. Hughes, J. Winget, Finite rotation effects in numerical integration of rate constitutive equations
arising in large-deformation analysis, International Journal for Numerical Methods in Engineering 15 (1980) 1862-1867.
"""

import math

from vmharness.explicit.kernels.vector import Vector, add, combine, cross, dot, inlined, scale
from vmharness.explicit.state import Array

Triad = tuple[Vector, Vector, Vector]

SMALL_ANGLE = 5e-3  # below it the series of tan is exact to round-off


@inlined
def half_rotation(t: Vector) -> Vector:
    """The Rodrigues vector of half the rotation: tan(theta/4) n from t = tan(theta/2) n."""
    return scale(1 / (1 + (1 + dot(t, t)) ** 0.5), t)


@inlined
def rodrigues_vector(w: Vector) -> Vector:
    """The Rodrigues vector tan(theta/2) n of the rotation vector w = theta n."""
    square = dot(w, w)
    if square < SMALL_ANGLE * SMALL_ANGLE:
        return scale(0.5 + square / 24.0 + square * square / 240.0, w)
    theta = math.sqrt(square)
    return scale(math.tan(0.5 * theta) / theta, w)


@inlined
def rotate_quaternion(s: float, u: Vector, t: Vector) -> tuple[float, Vector]:
    """The quaternion (s, u), followed by the rotation with the Rodrigues vector t."""
    norm = 1 / (1 + dot(t, t)) ** 0.5
    return norm * (s - dot(t, u)), scale(norm, add(add(u, scale(s, t)), cross(t, u)))


@inlined
def rotation_matrix(s: float, u: Vector) -> Triad:
    """The columns of the rotation matrix of the quaternion (s, u): the frame's axes e1, e2, e3 in space."""
    a, b, c = u
    return (
        (1 - 2 * (b * b + c * c), 2 * (a * b + s * c), 2 * (a * c - s * b)),
        (2 * (a * b - s * c), 1 - 2 * (a * a + c * c), 2 * (b * c + s * a)),
        (2 * (a * c + s * b), 2 * (b * c - s * a), 1 - 2 * (a * a + b * b)),
    )


@inlined
def rotated_axes(q: Array, w: Vector) -> Triad:
    """The axes in space of the orientation `q` (4,), after the rotation with the rotation vector w."""
    s, u = rotate_quaternion(q[0], (q[1], q[2], q[3]), rodrigues_vector(w))
    return rotation_matrix(s, u)


@inlined
def rotate_orientation(q: Array, w: Vector) -> None:
    """Rotate the orientation `q` (4,) by the rotation vector w; its norm is reset to 1."""
    s, u = rotate_quaternion(q[0], (q[1], q[2], q[3]), rodrigues_vector(w))
    norm = 1.0 / math.sqrt(s * s + dot(u, u))
    q[0], q[1], q[2], q[3] = norm * s, norm * u[0], norm * u[1], norm * u[2]


@inlined
def matvec(A: Triad, b: Vector) -> Vector:
    """A . b, where A holds the rows of a tensor."""
    return dot(A[0], b), dot(A[1], b), dot(A[2], b)


@inlined
def strain_in_frame(e: Triad, L: Triad) -> tuple[Vector, Vector]:
    """e_i . D e_j: the strains 11, 22, 33 and engineering shears 12, 23, 31 of the gradient L (its rows)."""
    L1, L2, L3 = matvec(L, e[0]), matvec(L, e[1]), matvec(L, e[2])
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
