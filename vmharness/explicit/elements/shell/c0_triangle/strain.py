"""Strain increments of one step, and their transpose: nodal forces and moments.

Strain increments are taken on the geometry at mid-step. The velocity at height z over the mid-surface is
v + z (omega_y, -omega_x, 0), linear in the plane. With a, b, c of frame.py

    d_xx = v_x,x + z k_xx,  k_xx = omega_y,x      2 d_zx = v_z,x + omega_y + a k_xx - b k_xy
    d_yy = v_y,y + z k_yy,  k_yy = -omega_x,y     2 d_yz = v_z,y - omega_x + c k_xx + b k_yy - a k_xy
    2 d_xy = v_x,y + v_y,x + z k_xy,  k_xy = omega_y,y - omega_x,x         (omega: mean of the nodes)

All vanish for every rigid motion v = v_0 + w x x, omega = w, and for a step of finite rotation: shell/_chord.py.

Forces are taken on the geometry at the end of the step. The power of the resultants (per unit length, over the area A)
is

    A (N . d + S_zx (v_z,x + omega_y) + S_yz (v_z,y - omega_x) + M* . k)
    M*_xx = M_xx + a S_zx + c S_yz,   M*_yy = M_yy + b S_yz,   M*_xy = M_xy - b S_zx - a S_yz

The coefficients of v,x and v,y give, through B, the forces of nodes 2 and 3; node 1 takes their sum, reversed.
"""

from vmharness.explicit.elements.shell._chord import chord_factor
from vmharness.explicit.elements.shell.c0_triangle.frame import Corners, frame
from vmharness.explicit.kernels.vector import Vector, add, combine, components, inlined, scale, subtract


@inlined
def increments(x: Corners, v: Corners, omega: Corners, dt: float) -> tuple[float, Vector, Vector, Vector]:
    """Area, increments of membrane strain, curvature and transverse shear.

    `x`: corners at mid-step; `v`, `omega`: velocity and angular velocity of the corners, as vectors in space.
    Membrane: e_xx, e_yy, 2 e_xy; curvature: the same per height; shear: 2 e_yz, 2 e_zx, 0.
    """
    triad, area, B1, B2, (a, b, c) = frame(x)
    v21, v31 = components(triad, subtract(v[1], v[0])), components(triad, subtract(v[2], v[0]))
    w21, w31 = (
        components(triad, subtract(omega[1], omega[0])),
        components(triad, subtract(omega[2], omega[0])),
    )
    v_x = add(scale(B1[0], v21), scale(B1[1], v31))  # dv/dx
    v_y = add(scale(B2[0], v21), scale(B2[1], v31))  # dv/dy
    w_x = add(scale(B1[0], w21), scale(B1[1], w31))
    w_y = add(scale(B2[0], w21), scale(B2[1], w31))

    membrane = scale(dt, (v_x[0], v_y[1], v_y[0] + v_x[1]))
    curvature = scale(dt, (w_x[1], -w_y[0], w_y[1] - w_x[0]))

    mean = components(triad, scale(1 / 3, add(add(omega[0], omega[1]), omega[2])))
    factor = dt * chord_factor(v_x, v_y, dt)
    shear = (
        factor * v_y[2] - dt * mean[0] + c * curvature[0] + b * curvature[1] - a * curvature[2],
        factor * v_x[2] + dt * mean[1] + a * curvature[0] - b * curvature[2],
        0.0,
    )
    return area, membrane, curvature, shear


@inlined
def nodal_forces(x: Corners, N: Vector, M: Vector, S: Vector) -> tuple[Corners, Corners]:
    """Internal forces and moments of nodes 1 to 3, as vectors in space; the nodes get the opposite.

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
