"""Internal forces and moments of the three nodes: the transpose of the rates, on the geometry at the end of the step.

Power of the resultants (per unit length, over the area A), with a, b, c of frame.py:

    A (N . d + S_zx (v_z,x + omega_y) + S_yz (v_z,y - omega_x) + M* . k)
    M*_xx = M_xx + a S_zx + c S_yz,   M*_yy = M_yy + b S_yz,   M*_xy = M_xy - b S_zx - a S_yz

The coefficients of v,x and v,y make the forces of nodes 2 and 3 through B; node 1 bears the opposite of both.
"""

from vmharness.explicit.elements.shell.c0_triangle.frame import Corners, frame
from vmharness.explicit.kernels.vector import Vector, add, combine, inlined, scale, subtract


@inlined
def nodal_forces(x: Corners, N: Vector, M: Vector, S: Vector) -> tuple[Corners, Corners]:
    """Internal forces and moments of nodes 1 to 3, as vectors in space; the nodes feel the opposite.

    `x`: corners; `N`, `M`: resultants xx, yy, xy; `S`: shear resultants yz, zx, 0.
    """
    triad, A, B1, B2, (a, b, c) = frame(x)

    by_v_x, by_v_y = (A * N[0], A * N[2], A * S[1]), (A * N[2], A * N[1], A * S[0])
    p = combine(triad, add(scale(B1[0], by_v_x), scale(B2[0], by_v_y)))
    q = combine(triad, add(scale(B1[1], by_v_x), scale(B2[1], by_v_y)))
    f = (scale(-1.0, add(p, q)), p, q)

    Mxx, Myy, Mxy = M[0] + a * S[1] + c * S[0], M[1] + b * S[0], M[2] - b * S[1] - a * S[0]
    by_w_x, by_w_y = (-A * Mxy, A * Mxx, 0.0), (-A * Myy, A * Mxy, 0.0)
    p = combine(triad, add(scale(B1[0], by_w_x), scale(B2[0], by_w_y)))
    q = combine(triad, add(scale(B1[1], by_w_x), scale(B2[1], by_w_y)))
    mean = combine(triad, (-A / 3 * S[0], A / 3 * S[1], 0.0))
    return f, (subtract(mean, add(p, q)), add(mean, p), add(mean, q))
