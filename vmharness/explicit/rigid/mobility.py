"""The mobility of a rigid body: angular velocity from angular momentum, where some components of it are given.

The mobility J = R I^-1 R^T takes angular momentum to angular velocity, omega = J L, and torque to acceleration. It is
zero about an axis that the body cannot turn about. Where the global component omega_i is given, the torque about that
axis is whatever the given motion takes, and the other components follow by

    omega += J_i (given - omega_i)/J_ii        J -= J_i J_i^T / J_ii        J_i: column i

once for each such component. Row and column i of J are then zero: momentum about a given axis has no effect.
"""

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import Triad
from vmharness.explicit.kernels.vector import Vector, combine, components, inlined
from vmharness.explicit.state import Array, Flags


@inlined
def principal_product(e: Triad, principal: Array, a: Vector) -> Vector:
    """R diag(`principal`) R^T a, with the principal axes `e`: I omega by moments (3,), I^-1 L by their inverse."""
    b = components(e, a)
    return combine(e, (principal[0] * b[0], principal[1] * b[1], principal[2] * b[2]))


@kernel
def set_mobility(J: Array, e: Triad, inverse: Array) -> None:
    """J (3, 3) = sum e_i e_i^T / I_i; `inverse` (3,): 1/I_i."""
    for i in range(3):
        for j in range(3):
            J[i, j] = inverse[0] * e[0][i] * e[0][j] + inverse[1] * e[1][i] * e[1][j]
            J[i, j] += inverse[2] * e[2][i] * e[2][j]


@kernel
def condition_on(J: Array, omega: Array, i: int, given: float) -> None:
    """Condition `J` (3, 3) and `omega` (3,) on omega_i = `given`."""
    pivot, change = J[i, i], given - omega[i]
    if pivot > 0.0:
        for j in range(3):
            omega[j] += J[i, j] / pivot * change
        column = (J[0, i], J[1, i], J[2, i])
        for j in range(3):
            for k in range(3):
                J[j, k] -= column[j] * column[k] / pivot
    for j in range(3):
        J[i, j] = J[j, i] = 0.0
    omega[i] = given


@kernel
def conditioned_product(
    J: Array, w: Array, e: Triad, inverse: Array, L: Vector, given: Flags, value: Array
) -> Vector:
    """R I^-1 R^T L, with the components `given` (3,) at their `value` (3,); `J` (3, 3) and `w` (3,) are buffers."""
    if not (given[0] or given[1] or given[2]):
        return principal_product(e, inverse, L)
    set_mobility(J, e, inverse)
    for i in range(3):
        w[i] = J[i, 0] * L[0] + J[i, 1] * L[1] + J[i, 2] * L[2]
    for i in range(3):
        if given[i]:
            condition_on(J, w, i, value[i])
    return w[0], w[1], w[2]
