"""Internal forces and moments of the four nodes: the transpose of the rates, on the geometry at the end of the step.

Power of the resultants (per unit length, over the area A) and of the hourglass forces Q_i, R_i:

    A (N_xx v_x,x + N_yy v_y,y + N_xy (v_x,y + v_y,x) + S_zx (v_z,x + omega_y) + S_yz (v_z,y - omega_x)
       + M_xx omega_y,x - M_yy omega_x,y + M_xy (omega_y,y - omega_x,x)) + Q . q + R . r

The coefficients of v,x and v,y make the forces +-p of nodes 1, 3 and +-q of nodes 2, 4 through B; every node bears
+-Q as the pattern h says, and the moments of the shear in equal parts (Belytschko, Lin, Tsay 1984).
"""

from vmharness.explicit.elements.shell.belytschko_tsay.frame import Corners, frame
from vmharness.explicit.kernels.vector import Vector, add, combine, inlined, scale, subtract


@inlined
def nodal_forces(
    x: Corners, N: Vector, M: Vector, S: Vector, Q: Vector, R: Vector
) -> tuple[Corners, Corners]:
    """Internal forces and moments of nodes 1 to 4, as vectors in space; the nodes feel the opposite.

    `x`: corners; `N`, `M`: resultants xx, yy, xy; `S`: shear resultants yz, zx, 0; `Q`: hourglass forces x, y, z;
    `R`: hourglass moments x, y, 0.
    """
    triad, A, B1, B2, h = frame(x)

    by_v_x = (
        A * N[0] - h[0] * Q[0],
        A * N[2] - h[0] * Q[1],
        A * S[1] - h[0] * Q[2] + h[2] * Q[0],
    )
    by_v_y = (
        A * N[2] - h[1] * Q[0],
        A * N[1] - h[1] * Q[1],
        A * S[0] - h[1] * Q[2] + h[2] * Q[1],
    )
    p = combine(triad, add(scale(B1[0], by_v_x), scale(B2[0], by_v_y)))
    q = combine(triad, add(scale(B1[1], by_v_x), scale(B2[1], by_v_y)))
    f_h = combine(triad, Q)
    f = (add(p, f_h), subtract(q, f_h), subtract(f_h, p), subtract(scale(-1.0, q), f_h))

    by_w_x = (-A * M[2] - h[0] * R[0], A * M[0] - h[0] * R[1], 0.0)
    by_w_y = (-A * M[1] - h[1] * R[0], A * M[2] - h[1] * R[1], 0.0)
    p = combine(triad, add(scale(B1[0], by_w_x), scale(B2[0], by_w_y)))
    q = combine(triad, add(scale(B1[1], by_w_x), scale(B2[1], by_w_y)))
    m_h = combine(triad, R)
    mean = combine(triad, (-0.25 * A * S[0], 0.25 * A * S[1], 0.0))
    odd, even = add(mean, m_h), subtract(mean, m_h)
    return f, (add(odd, p), add(even, q), subtract(odd, p), subtract(even, q))
