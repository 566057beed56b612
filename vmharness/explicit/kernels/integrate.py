"""The updates of the time loop over all nodes, as kernels. Arrays are (n, 3), inverse masses (n,)."""

from vmharness.explicit.kernels.compiled import concurrent, kernel
from vmharness.explicit.state import Array


@kernel
def clear(f: Array, moment: Array) -> None:
    """Set f = 0, moment = 0."""
    for i in range(f.shape[0]):
        for j in range(3):
            f[i, j] = 0.0
            moment[i, j] = 0.0


@concurrent
def accelerate(
    a: Array, alpha: Array, f: Array, moment: Array, inverse_mass: Array, inverse_inertia: Array
) -> float:
    """Set a = f/m, alpha = moment/inertia; a node without inertia has no angular acceleration.

    Return the sum of all squares of a and alpha, which is finite as long as all of them are.
    """
    size = 0.0
    for i in range(f.shape[0]):
        for j in range(3):
            a[i, j] = f[i, j] * inverse_mass[i]
            alpha[i, j] = moment[i, j] * inverse_inertia[i]
            size += a[i, j] * a[i, j] + alpha[i, j] * alpha[i, j]
    return size


@concurrent
def advance_velocity(v: Array, omega: Array, a: Array, alpha: Array, dt: float) -> None:
    """Add dt a to v, and dt alpha to omega."""
    for i in range(v.shape[0]):
        for j in range(3):
            v[i, j] += dt * a[i, j]
            omega[i, j] += dt * alpha[i, j]


@concurrent
def advance_position(x: Array, v: Array, dt: float) -> None:
    """Add dt v to x."""
    for i in range(x.shape[0]):
        for j in range(3):
            x[i, j] += dt * v[i, j]
