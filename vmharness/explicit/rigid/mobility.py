"""How a body turns under torque, where some components of its motion are given.

The mobility J = R I^-1 R^T takes angular momentum to angular velocity, omega = J L, and torque to acceleration. A
body that cannot turn about an axis has zero there. Where the global component omega_i is given, the torque about that
axis is whatever it takes, and the rest follows by

    omega += J_i (given - omega_i)/J_ii        J -= J_i J_i^T / J_ii        J_i: column i

once for each such component. What is left of J has no row or column i: momentum about a given axis does not count.
"""

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import Triad
from vmharness.explicit.kernels.vector import Vector, combine, components, inlined
from vmharness.explicit.model.state import Array


@inlined
def product(e: Triad, principal: Array, a: Vector) -> Vector:
    """R diag(principal) R^T a: of the inertia (3,) with omega, of its inverse with L; `e`: the principal axes."""
    b = components(e, a)
    return combine(e, (principal[0] * b[0], principal[1] * b[1], principal[2] * b[2]))


@kernel
def fill(J: Array, e: Triad, inverse: Array) -> None:
    """J (3, 3) = sum e_i e_i^T / I_i; `inverse` (3,): 1/I_i."""
    for i in range(3):
        for j in range(3):
            J[i, j] = inverse[0] * e[0][i] * e[0][j] + inverse[1] * e[1][i] * e[1][j]
            J[i, j] += inverse[2] * e[2][i] * e[2][j]


@kernel
def give(J: Array, omega: Array, i: int, given: float) -> None:
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
