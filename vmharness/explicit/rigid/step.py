"""One step of all rigid bodies, as kernels; the equations are in __init__.py.

Arrays of nodes are those of the state. By body (nb,): `centre`, the row of the centre; `first` (nb + 1,), where its
nodes begin in `nodes` (m,) and `arm` (m, 3), their places in principal axes; `q` (nb, 4), the principal axes in space;
`principal` and `inverse` (nb, 3), the moments I_i and 1/I_i; `L` and `torque` (nb, 3); `given` (nb, 3), which global
components of rotation are held or driven: their omega and alpha stand in the row of the centre.
"""

import math

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import Triad, rotate_orientation, rotated_axes, rotation_matrix
from vmharness.explicit.kernels.vector import Vector, add, combine, cross, dot, inlined, scale, subtract
from vmharness.explicit.model.state import Array
from vmharness.explicit.rigid.mobility import fill, give, product

Index = NDArray[np.intp]
Flags = NDArray[np.bool_]

ITERATIONS = 60  # the angle of a step is below 1, and each brings at least a binary digit
ROUND_OFF = 4e-16


@inlined
def row(a: Array, i: int) -> Vector:
    """Row i of an array (n, 3)."""
    return a[i, 0], a[i, 1], a[i, 2]


@inlined
def put(a: Array, i: int, b: Vector) -> None:
    """Set row i of an array (n, 3)."""
    a[i, 0], a[i, 1], a[i, 2] = b


@kernel
def gather(
    x: Array, f: Array, moment: Array, a: Array, inverse_mass: Array,
    centre: Index, first: Index, nodes: Index, torque: Array,
) -> None:  # fmt: skip
    """F and T of the nodes to the centre: f, a = F/M, and `torque` in place of the centre's moment."""
    for b in range(centre.size):
        c = centre[b]
        place, force, turning = row(x, c), row(f, c), row(moment, c)
        for k in range(first[b], first[b + 1]):
            i = nodes[k]
            push = row(f, i)
            force = add(force, push)
            turning = add(turning, add(row(moment, i), cross(subtract(row(x, i), place), push)))
        put(f, c, force)
        put(a, c, scale(inverse_mass[c], force))
        put(moment, c, (0.0, 0.0, 0.0))
        put(torque, b, turning)


@kernel
def condition(J: Array, w: Array, e: Triad, inverse: Array, L: Vector, given: Flags, value: Array) -> Vector:
    """R I^-1 R^T L, with the components `given` (3,) at their `value` (3,); `J` (3, 3) and `w` (3,) serve for it."""
    if not (given[0] or given[1] or given[2]):
        return product(e, inverse, L)
    fill(J, e, inverse)
    for i in range(3):
        w[i] = J[i, 0] * L[0] + J[i, 1] * L[1] + J[i, 2] * L[2]
    for i in range(3):
        if given[i]:
            give(J, w, i, value[i])
    return w[0], w[1], w[2]


@kernel
def respond(
    omega: Array, alpha: Array, dt: float, centre: Index, q: Array, principal: Array, inverse: Array,
    L: Array, torque: Array, given: Flags, spin: Array, reaction: Array, kinetic: Array,
) -> None:  # fmt: skip
    """omega_n (`spin`) and alpha_n under the torque at t_n, and the reaction of what is given.

    `reaction` (nb, 3) = I alpha + omega x I omega - T; `kinetic` (1,): the kinetic energy of rotation.
    """
    J, w, value = np.empty((3, 3)), np.empty(3), np.empty(3)
    kinetic[0] = 0.0
    for b in range(centre.size):
        c, T = centre[b], row(torque, b)
        e = rotation_matrix(q[b, 0], (q[b, 1], q[b, 2], q[b, 3]))
        for i in range(3):
            value[i] = omega[c, i] + 0.5 * dt * alpha[c, i]
        now = condition(J, w, e, inverse[b], add(row(L, b), scale(0.5 * dt, T)), given[b], value)
        momentum = product(e, principal[b], now)
        drive = subtract(T, cross(now, momentum))
        rate = condition(J, w, e, inverse[b], drive, given[b], alpha[c])
        needed = subtract(product(e, principal[b], rate), drive)
        for i in range(3):
            reaction[b, i] = needed[i] if given[b, i] else 0.0
        put(alpha, c, rate)
        put(spin, b, now)
        kinetic[0] += 0.5 * dot(now, momentum)


@kernel
def spread(x: Array, a: Array, alpha: Array, centre: Index, first: Index, nodes: Index, spin: Array) -> None:
    """a_k = a_c + alpha x r + omega x (omega x r), r = x_k - c."""
    for b in range(centre.size):
        c, w = centre[b], row(spin, b)
        place, moving, turning = row(x, c), row(a, c), row(alpha, c)
        for k in range(first[b], first[b + 1]):
            i = nodes[k]
            r = subtract(row(x, i), place)
            put(a, i, add(moving, add(cross(turning, r), cross(w, cross(w, r)))))
            put(alpha, i, turning)


@kernel
def rotate(omega: Array, dt: float, centre: Index, q: Array, inverse: Array, L: Array, given: Flags) -> float:
    """omega_{n+1/2} of the implicit midpoint rule for L_{n+1/2}, to round-off; the largest angle of the step.

    It is solved by iteration, from the omega that is there. Angles of more than 1 are left as they come.
    """
    J, w = np.empty((3, 3)), np.empty(3)
    largest = 0.0
    for b in range(centre.size):
        c = centre[b]
        for _ in range(ITERATIONS):
            before = row(omega, c)
            e = rotated_axes(q[b], scale(0.5 * dt, before))
            now = condition(J, w, e, inverse[b], row(L, b), given[b], omega[c])
            put(omega, c, now)
            change = subtract(now, before)
            if dot(change, change) <= ROUND_OFF**2 * dot(now, now):
                break
        largest = max(largest, dt * math.sqrt(dot(row(omega, c), row(omega, c))))
    return largest


@kernel
def carry(
    x: Array, v: Array, omega: Array, dt: float, centre: Index, first: Index, nodes: Index, arm: Array,
    q: Array, principal: Array, L: Array, given: Flags, turned: Array,
) -> None:  # fmt: skip
    """R_{n+1}, and the chord velocity that sets each node on c_{n+1} + R_{n+1} arm."""
    for b in range(centre.size):
        c = centre[b]
        w = row(omega, c)
        momentum = product(rotated_axes(q[b], scale(0.5 * dt, w)), principal[b], w)
        for i in range(3):
            if given[b, i]:  # momentum about a given axis is what the motion makes it
                L[b, i] = momentum[i]
        put(turned, b, add(row(turned, b), scale(dt, w)))
        rotate_orientation(q[b], scale(dt, w))
        e = rotation_matrix(q[b, 0], (q[b, 1], q[b, 2], q[b, 3]))
        place = add(row(x, c), scale(dt, row(v, c)))
        for k in range(first[b], first[b + 1]):
            i = nodes[k]
            end = add(place, combine(e, row(arm, k)))
            put(v, i, scale(1.0 / dt, subtract(end, row(x, i))))
            put(omega, i, w)
