"""The frame of the element: triad, area, gradient of a linear field, and the shear that curvature adds.

        3                  e1 = side 1-2, node 1 at (0, 0), node 2 at (x2, 0), node 3 at (x3, y3)
       / \\    e2           e3 = r21 x r31 / |r21 x r31|
      /   \\   |_ e1        e2 = e3 x e1
     1 --- 2

With linear fields and the deflection w, the shear w,x + omega_y would not vanish in pure bending, where w is quadratic.
On a side from I to J the mean of its tangential component does: (w_J - w_I) + t . (beta_I + beta_J)/2 = 0 with
beta = (omega_y, -omega_x), t = x_J - x_I. The linear field gamma = (a - c y, b + c x) with these three means is, at the
centre,

    gamma = grad(w + phi) + beta,   phi_I = 1/2 (kappa_xx x_I^2 + kappa_yy y_I^2 + kappa_xy x_I y_I)

with x_I, y_I from the centre and omega the mean of the nodes: phi is the deflection by the curvature of the element.
That is the shear of Kennedy, Belytschko, Lin (1986). The gradient of phi is

    phi,x = a kappa_xx - b kappa_xy                      a = (x2 - 2 x3)/6,   b = y3/6,   c = x3 (x3 - x2) / 2 y3
    phi,y = c kappa_xx + b kappa_yy - a kappa_xy
"""

from vmharness.explicit.kernels.simd import put, vector
from vmharness.explicit.kernels.vector import Vector, cross, dot, inlined, scale, subtract, unit
from vmharness.explicit.state import Array

Corners = tuple[Vector, Vector, Vector]


@inlined
def frame(
    x: Corners,
) -> tuple[tuple[Vector, Vector, Vector], float, tuple[float, float], tuple[float, float], Vector]:
    """Triad (e1, e2, e3), area A, (B_12, B_13), (B_22, B_23), and (a, b, c) of the shear.

    `x`: three corners in space. dphi/dx = B_12 (phi_2 - phi_1) + B_13 (phi_3 - phi_1), dphi/dy with B_22 and B_23.
    """
    r21, r31 = subtract(x[1], x[0]), subtract(x[2], x[0])
    normal = cross(r21, r31)
    double_area = dot(normal, normal) ** 0.5
    e1, e3 = unit(r21), scale(1 / double_area, normal)
    e2 = cross(e3, e1)
    x2, x3, y3 = dot(r21, e1), dot(r31, e1), dot(r31, e2)
    by_curvature = ((x2 - 2 * x3) / 6, y3 / 6, 0.5 * x3 * (x3 - x2) / y3)
    return (e1, e2, e3), 0.5 * double_area, (1 / x2, 0.0), (-x3 / double_area, 1 / y3), by_curvature


@inlined
def load_corners(work: Array, row: int, e: int) -> Corners:
    """The vectors at the three nodes of element e."""
    return vector(work, row, e), vector(work, row + 3, e), vector(work, row + 6, e)


@inlined
def store_corners(work: Array, row: int, e: int, a: Corners) -> None:
    """Store the vectors at the three nodes of element e."""
    put(work, row, e, a[0])
    put(work, row + 3, e, a[1])
    put(work, row + 6, e, a[2])
