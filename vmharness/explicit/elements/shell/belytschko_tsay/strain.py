"""Strain and hourglass increments of one step, and their transpose: nodal forces and moments.

Strain increments are taken on the geometry at mid-step. The velocity at height z over the mid-surface is
v + z (omega_y, -omega_x, 0). With one point in the plane (Belytschko, Lin, Tsay 1984)

    d_xx = v_x,x + z omega_y,x        2 d_xy = v_x,y + v_y,x + z (omega_y,y - omega_x,x)
    d_yy = v_y,y - z omega_x,y        2 d_zx = v_z,x + omega_y,   2 d_yz = v_z,y - omega_x   (omega: mean of the nodes)

The hourglass rates are

    gamma . v_x + (h . z) v_z,x,   gamma . v_y + (h . z) v_z,y,   gamma . v_z,   gamma . omega_x,   gamma . omega_y

The terms with h . z compensate what a rigid rotation of a warped element adds to gamma . v, so that all thirteen rates
vanish for every rigid motion v = v_0 + w x x, omega = w. In a step of finite rotation v_z,x and v_z,y in the shear are
scaled to agree with omega of the nodes: shell/_chord.py.

Forces are taken on the geometry at the end of the step. The power of the resultants (per unit length, over the area A)
and of the hourglass forces Q_i and moments R_i is

    A (N_xx v_x,x + N_yy v_y,y + N_xy (v_x,y + v_y,x) + S_zx (v_z,x + omega_y) + S_yz (v_z,y - omega_x)
       + M_xx omega_y,x - M_yy omega_x,y + M_xy (omega_y,y - omega_x,x)) + Q . q + R . r

The coefficients of v,x and v,y give, through B, forces +-p of nodes 1, 3 and +-q of nodes 2, 4. Each node takes +-Q
with the sign of the pattern h, and a quarter of the moments of the shear. As the transpose of the rates, the forces and
moments of an element are in equilibrium, also of a warped one.
"""

from vmharness.explicit.elements.shell._chord import chord_factor
from vmharness.explicit.elements.shell.belytschko_tsay.frame import Corners, frame, hourglass_pattern
from vmharness.explicit.kernels.vector import Vector, add, combine, components, inlined, scale, subtract


@inlined
def increments(
    x: Corners, v: Corners, omega: Corners, dt: float
) -> tuple[float, Vector, Vector, Vector, Vector, Vector]:
    """Area, increments of membrane strain, curvature and transverse shear, hourglass rates of v and of omega.

    `x`: corners at mid-step; `v`, `omega`: velocity and angular velocity of the corners, as vectors in space.
    Membrane: e_xx, e_yy, 2 e_xy; curvature: the same per height; shear: 2 e_yz, 2 e_zx, 0; rates: x, y, z; x, y, 0.
    """
    triad, area, B1, B2, h = frame(x)
    v13, v24 = components(triad, subtract(v[0], v[2])), components(triad, subtract(v[1], v[3]))
    w13, w24 = (
        components(triad, subtract(omega[0], omega[2])),
        components(triad, subtract(omega[1], omega[3])),
    )
    v_x = add(scale(B1[0], v13), scale(B1[1], v24))  # dv/dx
    v_y = add(scale(B2[0], v13), scale(B2[1], v24))  # dv/dy
    w_x = add(scale(B1[0], w13), scale(B1[1], w24))
    w_y = add(scale(B2[0], w13), scale(B2[1], w24))

    membrane = scale(dt, (v_x[0], v_y[1], v_y[0] + v_x[1]))
    curvature = scale(dt, (w_x[1], -w_y[0], w_y[1] - w_x[0]))

    mean = components(triad, scale(0.25, add(add(omega[0], omega[1]), add(omega[2], omega[3]))))
    factor = chord_factor(v_x, v_y, dt)
    shear = scale(dt, (factor * v_y[2] - mean[0], factor * v_x[2] + mean[1], 0.0))

    v_h = components(triad, hourglass_pattern(v))
    w_h = components(triad, hourglass_pattern(omega))
    gamma_v = subtract(v_h, add(scale(h[0], v_x), scale(h[1], v_y)))
    gamma_w = subtract(w_h, add(scale(h[0], w_x), scale(h[1], w_y)))
    warped = (gamma_v[0] + h[2] * v_x[2], gamma_v[1] + h[2] * v_y[2], gamma_v[2])
    return area, membrane, curvature, shear, warped, (gamma_w[0], gamma_w[1], 0.0)


@inlined
def nodal_forces(
    x: Corners, N: Vector, M: Vector, S: Vector, Q: Vector, R: Vector
) -> tuple[Corners, Corners]:
    """Internal forces and moments of nodes 1 to 4, as vectors in space; the nodes get the opposite.

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
