"""One step of all rigid bodies, as kernels; the equations are in the docstring of the package.

Arrays of nodes are those of the state. Arrays by body (nb,): `centre`, the row of the centre; `first` (nb + 1,), where
its nodes begin in `nodes` (m,) and in `arm` (m, 3), their positions in principal axes; `q` (nb, 4), the orientation of
the principal axes; `principal` and `inverse` (nb, 3), the moments I_i and 1/I_i; `L` and `torque` (nb, 3); `given`
(nb, 3), the global components of rotation that are held or driven: their omega and alpha are in the row of the centre.
"""

import math

import numpy as np

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import rotate_orientation, rotated_axes, rotation_matrix
from vmharness.explicit.kernels.vector import add, combine, cross, dot, row, scale, set_row, subtract
from vmharness.explicit.rigid.mobility import conditioned_product, principal_product
from vmharness.explicit.state import Array, Flags, Index

ITERATIONS = 60  # the angle of a step is below 1, and each iteration gains at least one binary digit
ROUND_OFF = 4e-16


@kernel
def gather_forces(
    x: Array, f: Array, moment: Array, a: Array, inverse_mass: Array,
    centre: Index, first: Index, nodes: Index, torque: Array,
) -> None:  # fmt: skip
    """Sum forces and moments of the nodes at the centre: f, a = F/M, and `torque`, which takes over its moment."""
    for b in range(centre.size):
        c = centre[b]
        at, force, total = row(x, c), row(f, c), row(moment, c)
        for k in range(first[b], first[b + 1]):
            i = nodes[k]
            nodal = row(f, i)
            force = add(force, nodal)
            total = add(total, add(row(moment, i), cross(subtract(row(x, i), at), nodal)))
        set_row(f, c, force)
        set_row(a, c, scale(inverse_mass[c], force))
        set_row(moment, c, (0.0, 0.0, 0.0))
        set_row(torque, b, total)


@kernel
def angular_response(
    omega: Array, alpha: Array, dt: float, centre: Index, q: Array, principal: Array, inverse: Array,
    L: Array, torque: Array, given: Flags, spin: Array, reaction: Array, kinetic: Array,
) -> None:  # fmt: skip
    """Set omega_n (`spin`) and alpha_n under the torque at t_n, and the reaction at the given components.

    `reaction` (nb, 3) = I alpha + omega x I omega - T; `kinetic` (1,): the kinetic energy of rotation.
    """
    J, w, value = np.empty((3, 3)), np.empty(3), np.empty(3)
    kinetic[0] = 0.0
    for b in range(centre.size):
        c, T = centre[b], row(torque, b)
        e = rotation_matrix(q[b, 0], (q[b, 1], q[b, 2], q[b, 3]))
        for i in range(3):
            value[i] = omega[c, i] + 0.5 * dt * alpha[c, i]
        now = conditioned_product(J, w, e, inverse[b], add(row(L, b), scale(0.5 * dt, T)), given[b], value)
        momentum = principal_product(e, principal[b], now)
        drive = subtract(T, cross(now, momentum))
        rate = conditioned_product(J, w, e, inverse[b], drive, given[b], alpha[c])
        needed = subtract(principal_product(e, principal[b], rate), drive)
        for i in range(3):
            reaction[b, i] = needed[i] if given[b, i] else 0.0
        set_row(alpha, c, rate)
        set_row(spin, b, now)
        kinetic[0] += 0.5 * dot(now, momentum)


@kernel
def accelerate_nodes(
    x: Array, a: Array, alpha: Array, centre: Index, first: Index, nodes: Index, spin: Array
) -> None:
    """a_k = a_c + alpha x r + omega x (omega x r), r = x_k - c."""
    for b in range(centre.size):
        c, w = centre[b], row(spin, b)
        at, linear, angular = row(x, c), row(a, c), row(alpha, c)
        for k in range(first[b], first[b + 1]):
            i = nodes[k]
            r = subtract(row(x, i), at)
            set_row(a, i, add(linear, add(cross(angular, r), cross(w, cross(w, r)))))
            set_row(alpha, i, angular)


@kernel
def mid_step_velocity(
    omega: Array, dt: float, centre: Index, q: Array, inverse: Array, L: Array, given: Flags
) -> float:
    """Solve the implicit midpoint rule for omega_{n+1/2}, to round-off; return the largest angle of the step.

    Fixed-point iteration begins at the present omega. It need not converge for an angle above 1: the caller checks it.
    """
    J, w = np.empty((3, 3)), np.empty(3)
    largest = 0.0
    for b in range(centre.size):
        c = centre[b]
        for _ in range(ITERATIONS):
            before = row(omega, c)
            e = rotated_axes(q[b], scale(0.5 * dt, before))
            now = conditioned_product(J, w, e, inverse[b], row(L, b), given[b], omega[c])
            set_row(omega, c, now)
            change = subtract(now, before)
            if dot(change, change) <= ROUND_OFF**2 * dot(now, now):
                break
        largest = max(largest, dt * math.sqrt(dot(row(omega, c), row(omega, c))))
    return largest


@kernel
def move_nodes(
    x: Array, v: Array, omega: Array, dt: float, centre: Index, first: Index, nodes: Index, arm: Array,
    q: Array, principal: Array, L: Array, given: Flags, angle: Array,
) -> None:  # fmt: skip
    """Set R_{n+1}, and the chord velocity that brings each node to c_{n+1} + R_{n+1} arm; `angle` is int omega dt."""
    for b in range(centre.size):
        c = centre[b]
        w = row(omega, c)
        momentum = principal_product(rotated_axes(q[b], scale(0.5 * dt, w)), principal[b], w)
        for i in range(3):
            if given[b, i]:  # the given motion determines the momentum about this axis
                L[b, i] = momentum[i]
        set_row(angle, b, add(row(angle, b), scale(dt, w)))
        rotate_orientation(q[b], scale(dt, w))
        e = rotation_matrix(q[b, 0], (q[b, 1], q[b, 2], q[b, 3]))
        centre_end = add(row(x, c), scale(dt, row(v, c)))
        for k in range(first[b], first[b + 1]):
            i = nodes[k]
            end = add(centre_end, combine(e, row(arm, k)))
            set_row(v, i, scale(1.0 / dt, subtract(end, row(x, i))))
            set_row(omega, i, w)
