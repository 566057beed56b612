"""Equations of joints, which hold points of two bodies together along given directions, as kernels over rows (nr,).

Row r holds point 1 of body b_1 and point 2 of body b_2 together along the unit vector d. Its multiplier lambda is a
force lambda d at the point of body 1, and -lambda d at that of body 2:

    K_rs = sum over bodies of (d_r, r x d_r) . M^-1 (d_s, r x d_s)        K lambda = -(relative acceleration along d)

The mobility of a body is that which its held directions and given rotations leave.
"""

import numpy as np

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import rotated_axes, rotation_matrix
from vmharness.explicit.kernels.vector import add, combine, cross, dot, row, scale, set_row, subtract
from vmharness.explicit.rigid.mobility import condition_on, set_mobility
from vmharness.explicit.state import Array, Flags, Index


@kernel
def constraint_matrix(
    x: Array, centre: Index, nodes: Index, point: Index, body: Index, d: Array, movable: Array, q: Array,
    inverse: Array, given: Flags, lever: Array, response: Array, K: Array,
) -> None:  # fmt: skip
    """Set K (nr, nr), `lever` (nr, 2, 3) = r x d and `response` = J (r x d) of both bodies.

    `point` (nr, 2): places in `nodes`; `body` (nr, 2); `movable` (nb, 3): 1/M, or 0 where the centre is held.
    """
    J, w = np.empty((3, 3)), np.zeros(3)
    for r in range(len(d)):
        for side in range(2):
            b = body[r, side]
            arm = subtract(row(x, nodes[point[r, side]]), row(x, centre[b]))
            set_row(lever[r], side, cross(arm, row(d, r)))
            set_mobility(J, rotation_matrix(q[b, 0], (q[b, 1], q[b, 2], q[b, 3])), inverse[b])
            for i in range(3):
                if given[b, i]:
                    condition_on(J, w, i, 0.0)
            t = row(lever[r], side)
            set_row(response[r], side, (dot(row(J, 0), t), dot(row(J, 1), t), dot(row(J, 2), t)))
    for r in range(len(d)):
        for s in range(len(d)):
            K[r, s] = 0.0
            for i in range(2):
                for j in range(2):
                    if body[r, i] == body[s, j]:
                        sign = 1.0 if i == j else -1.0
                        for k in range(3):
                            K[r, s] += sign * d[r, k] * movable[body[r, i], k] * d[s, k]
                            K[r, s] += sign * lever[r, i, k] * response[s, j, k]


@kernel
def relative_acceleration(
    x: Array, a: Array, alpha: Array, centre: Index, nodes: Index, point: Index, body: Index, d: Array,
    spin: Array, out: Array,
) -> None:  # fmt: skip
    """Set `out` (nr,), the acceleration of point 1 relative to point 2 along d."""
    for r in range(len(d)):
        apart = (0.0, 0.0, 0.0)
        for side in range(2):
            b = body[r, side]
            c, w = centre[b], row(spin, b)
            arm = subtract(row(x, nodes[point[r, side]]), row(x, c))
            at = add(row(a, c), add(cross(row(alpha, c), arm), cross(w, cross(w, arm))))
            apart = subtract(at, apart)
        out[r] = -dot(apart, row(d, r))


@kernel
def apply_multipliers(
    linear: Array, angular: Array, centre: Index, body: Index, d: Array, movable: Array, lever: Array,
    multiplier: Array,
) -> None:  # fmt: skip
    """Add the effect of `multiplier` (nr,) to the centres' `linear` (n, 3), by 1/M, and to `angular` (nb, 3).

    For forces these are acceleration and torque, for impulses velocity and angular momentum.
    """
    for r in range(len(d)):
        for side in range(2):
            b, amount = body[r, side], multiplier[r] if side == 0 else -multiplier[r]
            for k in range(3):
                linear[centre[b], k] += amount * movable[b, k] * d[r, k]
                angular[b, k] += amount * lever[r, side, k]


@kernel
def end_gaps(
    x: Array, v: Array, omega: Array, dt: float, centre: Index, arm: Array, point: Index, body: Index,
    d: Array, q: Array, out: Array,
) -> None:  # fmt: skip
    """Set `out` (nr,), the distance of point 1 from point 2 along d at the end of the step."""
    for r in range(len(d)):
        apart = (0.0, 0.0, 0.0)
        for side in range(2):
            b = body[r, side]
            c = centre[b]
            e = rotated_axes(q[b], scale(dt, row(omega, c)))
            end = add(add(row(x, c), scale(dt, row(v, c))), combine(e, row(arm, point[r, side])))
            apart = subtract(end, apart)
        out[r] = -dot(apart, row(d, r))
