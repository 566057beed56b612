"""Directions in which joints hold pairs of points together, as kernels over rows (nr,).

Row r holds point 1 of body b_1 and point 2 of body b_2 together along the unit vector d. A multiplier lambda pushes
body 1 with lambda d at its point and body 2 with -lambda d; G is the motion of a body by a unit of it:

    K_rs = sum over bodies of (d_r, r x d_r) . M^-1 (d_s, r x d_s)        K lambda = -(relative acceleration along d)

The mobility of a body is what its held directions and given rotations leave.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import rotated_axes, rotation_matrix
from vmharness.explicit.kernels.vector import add, combine, cross, dot, scale, subtract
from vmharness.explicit.model.state import Array
from vmharness.explicit.rigid.mobility import fill, give
from vmharness.explicit.rigid.step import put, row

Index = NDArray[np.intp]
Flags = NDArray[np.bool_]


@kernel
def couple(
    x: Array, centre: Index, nodes: Index, point: Index, body: Index, d: Array, movable: Array, q: Array,
    inverse: Array, given: Flags, turning: Array, spinning: Array, K: Array,
) -> None:  # fmt: skip
    """`turning` (nr, 2, 3) = r x d and `spinning` = J (r x d) of both bodies, and K (nr, nr).

    `point` (nr, 2): places in `nodes`; `body` (nr, 2); `movable` (nb, 3): 1/M, or 0 where the centre is held.
    """
    J, w = np.empty((3, 3)), np.zeros(3)
    for r in range(len(d)):
        for side in range(2):
            b = body[r, side]
            arm = subtract(row(x, nodes[point[r, side]]), row(x, centre[b]))
            put(turning[r], side, cross(arm, row(d, r)))
            fill(J, rotation_matrix(q[b, 0], (q[b, 1], q[b, 2], q[b, 3])), inverse[b])
            for i in range(3):
                if given[b, i]:
                    give(J, w, i, 0.0)
            t = row(turning[r], side)
            put(spinning[r], side, (dot(row(J, 0), t), dot(row(J, 1), t), dot(row(J, 2), t)))
    for r in range(len(d)):
        for s in range(len(d)):
            K[r, s] = 0.0
            for i in range(2):
                for j in range(2):
                    if body[r, i] == body[s, j]:
                        sign = 1.0 if i == j else -1.0
                        for k in range(3):
                            K[r, s] += sign * d[r, k] * movable[body[r, i], k] * d[s, k]
                            K[r, s] += sign * turning[r, i, k] * spinning[s, j, k]


@kernel
def relative(
    x: Array, a: Array, alpha: Array, centre: Index, nodes: Index, point: Index, body: Index, d: Array,
    spin: Array, out: Array,
) -> None:  # fmt: skip
    """`out` (nr,): the acceleration of point 1 against point 2 along d."""
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
def push(
    a: Array, turned: Array, centre: Index, body: Index, d: Array, movable: Array, turning: Array, by: Array
) -> None:
    """What multipliers `by` (nr,) make of `a` (n, 3) at the centres, by 1/M, and of `turned` (nb, 3)."""
    for r in range(len(d)):
        for side in range(2):
            b, amount = body[r, side], by[r] if side == 0 else -by[r]
            for k in range(3):
                a[centre[b], k] += amount * movable[b, k] * d[r, k]
                turned[b, k] += amount * turning[r, side, k]


@kernel
def gaps(
    x: Array, v: Array, omega: Array, dt: float, centre: Index, arm: Array, point: Index, body: Index,
    d: Array, q: Array, out: Array,
) -> None:  # fmt: skip
    """`out` (nr,): how far point 1 is from point 2 along d at the end of the step."""
    for r in range(len(d)):
        apart = (0.0, 0.0, 0.0)
        for side in range(2):
            b = body[r, side]
            c = centre[b]
            e = rotated_axes(q[b], scale(dt, row(omega, c)))
            end = add(add(row(x, c), scale(dt, row(v, c))), combine(e, row(arm, point[r, side])))
            apart = subtract(end, apart)
        out[r] = -dot(apart, row(d, r))
