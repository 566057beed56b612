"""Strain increments and hourglass increments of one step, from nodal velocities on the geometry at mid-step.

Velocity at height z over the mid-surface: v + z (omega_y, -omega_x, 0). With one point in the plane
(Belytschko, Lin, Tsay 1984)

    d_xx = v_x,x + z omega_y,x        2 d_xy = v_x,y + v_y,x + z (omega_y,y - omega_x,x)
    d_yy = v_y,y - z omega_x,y        2 d_zx = v_z,x + omega_y,   2 d_yz = v_z,y - omega_x   (omega: the nodes' mean)

Hourglass rates:

    gamma . v_x + (h . z) v_z,x,   gamma . v_y + (h . z) v_z,y,   gamma . v_z,   gamma . omega_x,   gamma . omega_y

The terms with h . z take out what a rigid rotation of a warped element does to gamma . v: all thirteen rates vanish
for any v = v_0 + w x x, omega = w. Forces are the transpose, so they balance, moments included, when warped too.

In a step of finite rotation v_z,x and v_z,y in the shear are scaled to agree with the nodes' omega: shell/chord.py.
"""

from vmharness.explicit.elements.shell._chord import chord
from vmharness.explicit.elements.shell.belytschko_tsay.frame import Corners, frame, hourglass_pattern
from vmharness.explicit.kernels.vector import Vector, add, components, inlined, scale, subtract


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
    turn = chord(v_x, v_y, dt)
    shear = scale(dt, (turn * v_y[2] - mean[0], turn * v_x[2] + mean[1], 0.0))

    v_h = components(triad, hourglass_pattern(v))
    w_h = components(triad, hourglass_pattern(omega))
    gamma_v = subtract(v_h, add(scale(h[0], v_x), scale(h[1], v_y)))
    gamma_w = subtract(w_h, add(scale(h[0], w_x), scale(h[1], w_y)))
    warped = (gamma_v[0] + h[2] * v_x[2], gamma_v[1] + h[2] * v_y[2], gamma_v[2])
    return area, membrane, curvature, shear, warped, (gamma_w[0], gamma_w[1], 0.0)
