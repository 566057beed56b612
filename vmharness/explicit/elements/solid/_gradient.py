"""Volume and gradients of a hexahedron with trilinear faces, from its patterns x_1 to x_7 (see _pattern.py).

With g_1 = dx/dxi, g_2 = dx/deta, g_3 = dx/dzeta, the Jacobian j = g_1 . g_2 x g_3 and G_1 = g_2 x g_3, ... cyclic,

    j grad phi = phi,xi G_1 + phi,eta G_2 + phi,zeta G_3 = sum b_k phi_k

    V = int j,   mean gradient = 1/V sum phi_k int b_k

The integrals over the cube are exact: they are the derivatives of the volume, which Flanagan and Belytschko take for B
(International Journal for Numerical Methods in Engineering 17 (1981) 679-706), in terms of patterns. The hourglass
pattern 7 does not enter.
"""

import numpy as np

from vmharness.explicit.elements.solid._pattern import Patterns, patterns
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import Triad
from vmharness.explicit.kernels.vector import Vector, add, cross, dot, inlined, scale
from vmharness.explicit.state import Array

Means = tuple[Vector, Vector, Vector, Vector, Vector, Vector]


@inlined
def mean(x: Patterns) -> tuple[float, Means]:
    """V and int b_k, k = 1 to 6: dV/dx_k.

    int b_1 = 8 (x_2 x x_3 + x_6 x x_5 / 3),   int b_4 = 8/3 (x_3 x x_5 + x_6 x x_2),   the others cyclic
    """
    x1, x2, x3, x4, x5, x6, _ = x
    b1 = add(scale(8.0, cross(x2, x3)), scale(8 / 3, cross(x6, x5)))
    b2 = add(scale(8.0, cross(x3, x1)), scale(8 / 3, cross(x4, x6)))
    b3 = add(scale(8.0, cross(x1, x2)), scale(8 / 3, cross(x5, x4)))
    b4 = scale(8 / 3, add(cross(x3, x5), cross(x6, x2)))
    b5 = scale(8 / 3, add(cross(x1, x6), cross(x4, x3)))
    b6 = scale(8 / 3, add(cross(x2, x4), cross(x5, x1)))
    volume = x1[0] * b1[0] + x2[0] * b2[0] + x3[0] * b3[0] + x4[0] * b4[0] + x5[0] * b5[0] + x6[0] * b6[0]
    return volume, (b1, b2, b3, b4, b5, b6)


@inlined
def at_point(x: Patterns, xi: float, eta: float, zeta: float) -> tuple[float, Patterns]:
    """j and b_k, k = 1 to 7, at a point."""
    x1, x2, x3, x4, x5, x6, x7 = x
    g1 = add(add(x1, scale(eta, x6)), add(scale(zeta, x5), scale(eta * zeta, x7)))
    g2 = add(add(x2, scale(xi, x6)), add(scale(zeta, x4), scale(zeta * xi, x7)))
    g3 = add(add(x3, scale(xi, x5)), add(scale(eta, x4), scale(xi * eta, x7)))
    b1, b2, b3 = cross(g2, g3), cross(g3, g1), cross(g1, g2)
    b4 = add(scale(zeta, b2), scale(eta, b3))
    b5 = add(scale(zeta, b1), scale(xi, b3))
    b6 = add(scale(eta, b1), scale(xi, b2))
    b7 = add(add(scale(eta * zeta, b1), scale(zeta * xi, b2)), scale(xi * eta, b3))
    return dot(g1, b1), (b1, b2, b3, b4, b5, b6, b7)


@inlined
def mean_velocity_gradient(v: Patterns, volume: float, b: Means) -> Triad:
    """Rows of L = 1/V sum v_k (x) int b_k."""
    by_volume = 1 / volume
    return _row(v, b, 0, by_volume), _row(v, b, 1, by_volume), _row(v, b, 2, by_volume)


@inlined
def _row(v: Patterns, b: Means, i: int, by_volume: float) -> Vector:
    first = add(add(scale(v[0][i], b[0]), scale(v[1][i], b[1])), scale(v[2][i], b[2]))
    second = add(add(scale(v[3][i], b[3]), scale(v[4][i], b[4])), scale(v[5][i], b[5]))
    return scale(by_volume, add(first, second))


@inlined
def velocity_gradient(v: Patterns, jacobian: float, b: Patterns) -> Triad:
    """Rows of L = 1/j sum v_k (x) b_k at a point."""
    by_jacobian = 1 / jacobian
    return (
        _row_at(v, b, 0, by_jacobian),
        _row_at(v, b, 1, by_jacobian),
        _row_at(v, b, 2, by_jacobian),
    )


@inlined
def _row_at(v: Patterns, b: Patterns, i: int, by_jacobian: float) -> Vector:
    first = add(add(scale(v[0][i], b[0]), scale(v[1][i], b[1])), scale(v[2][i], b[2]))
    second = add(add(scale(v[3][i], b[3]), scale(v[4][i], b[4])), scale(v[5][i], b[5]))
    return scale(by_jacobian, add(add(first, second), scale(v[6][i], b[6])))


@inlined
def largest_face(x: Patterns) -> float:
    """Largest area of a face: half the cross product of its diagonals, 4 (x_2 + x_6) x (x_3 + x_5) for xi = 1."""
    x1, x2, x3, x4, x5, x6, _ = x
    square = max(
        max(_squared_face(x2, x6, x3, x5), _squared_face(x3, x4, x1, x6)), _squared_face(x1, x5, x2, x4)
    )
    return square**0.5


@inlined
def _squared_face(a: Vector, da: Vector, b: Vector, db: Vector) -> float:
    """The larger of two opposite faces, squared: 16 |(a +- da) x (b +- db)|^2."""
    even, odd = add(cross(a, b), cross(da, db)), add(cross(a, db), cross(da, b))
    cross_term = abs(dot(even, odd))
    return 16 * (dot(even, even) + dot(odd, odd) + 2 * cross_term)


def measures(x: Array) -> tuple[Array, Array, Array]:
    """Volume V, sum |int b_k|^2 and length V / largest face (ne,), of elements with the corners `x (ne, 8, 3)`."""
    volume, squares, length = np.empty((3, len(x)))
    _measure(np.ascontiguousarray(x), volume, squares, length)
    return volume, squares, length


@kernel
def _measure(x: Array, volume: Array, squares: Array, length: Array) -> None:
    for e in range(len(x)):
        p = patterns(
            (
                _corner(x, e, 0),
                _corner(x, e, 1),
                _corner(x, e, 2),
                _corner(x, e, 3),
                _corner(x, e, 4),
                _corner(x, e, 5),
                _corner(x, e, 6),
                _corner(x, e, 7),
            )
        )
        volume[e], b = mean(p)
        squares[e] = dot(b[0], b[0]) + dot(b[1], b[1]) + dot(b[2], b[2])
        squares[e] += dot(b[3], b[3]) + dot(b[4], b[4]) + dot(b[5], b[5])
        length[e] = volume[e] / largest_face(p)


@inlined
def _corner(x: Array, e: int, i: int) -> Vector:
    return x[e, i, 0], x[e, i, 1], x[e, i, 2]
