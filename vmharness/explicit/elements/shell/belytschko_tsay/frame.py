"""The frame of the element: triad, area, and gradient of a nodal field at the centre.

        4 ------- 3
       /    e2   /        e3 = r31 x r42 / |r31 x r42|    (normal to both diagonals)
      /     |_ e1         e1 = side 1-2 without its part along e3
     1 ------- 2          e2 = e3 x e1

A bilinear field phi has at the centre the gradient (Belytschko, Lin, Tsay 1984)

    dphi/dx = B_1I phi_I,   B_1 = (y24, y31, y42, y13) / 2A,   y24 = y_2 - y_4, ...
    dphi/dy = B_2I phi_I,   B_2 = (x42, x13, x24, x31) / 2A

The third column of B is minus the first and the fourth minus the second: only the differences phi_1 - phi_3 and
phi_2 - phi_4 enter, and both are zero for the hourglass pattern h = (1, -1, 1, -1). The projection (Flanagan and
Belytschko 1981)

    gamma_I = h_I - (h . x) B_1I - (h . y) B_2I

is zero for every linear field, and 4 for that pattern.
"""

from vmharness.explicit.kernels.simd import put, vector
from vmharness.explicit.kernels.vector import Vector, components, cross, dot, inlined, scale, subtract, unit
from vmharness.explicit.state import Array

Corners = tuple[Vector, Vector, Vector, Vector]


@inlined
def hourglass_pattern(a: Corners) -> Vector:
    """h_I a_I = a_1 - a_2 + a_3 - a_4 of a nodal vector field."""
    return subtract(subtract(a[0], a[1]), subtract(a[3], a[2]))


@inlined
def frame(
    x: Corners,
) -> tuple[tuple[Vector, Vector, Vector], float, tuple[float, float], tuple[float, float], Vector]:
    """Triad (e1, e2, e3), area A, (B_11, B_12), (B_21, B_22), and (h . x, h . y, h . z) in the triad.

    `x`: four corners in space. h . z is four times the warp: how far each corner lies off the mean plane.
    """
    r13, r24 = subtract(x[0], x[2]), subtract(x[1], x[3])
    normal = cross(r13, r24)
    double_area = dot(normal, normal) ** 0.5
    e3 = scale(1 / double_area, normal)
    r21 = subtract(x[1], x[0])
    e1 = unit(subtract(r21, scale(dot(r21, e3), e3)))
    e2 = cross(e3, e1)
    B1 = (dot(r24, e2) / double_area, -dot(r13, e2) / double_area)
    B2 = (-dot(r24, e1) / double_area, dot(r13, e1) / double_area)
    triad = (e1, e2, e3)
    return triad, 0.5 * double_area, B1, B2, components(triad, hourglass_pattern(x))


@inlined
def load_corners(work: Array, row: int, e: int) -> Corners:
    """The vectors at the four nodes of element e."""
    return vector(work, row, e), vector(work, row + 3, e), vector(work, row + 6, e), vector(work, row + 9, e)


@inlined
def store_corners(work: Array, row: int, e: int, a: Corners) -> None:
    """Store the vectors at the four nodes of element e."""
    put(work, row, e, a[0])
    put(work, row + 3, e, a[1])
    put(work, row + 6, e, a[2])
    put(work, row + 9, e, a[3])
