"""The rigid motion that comes nearest to velocities of points."""

import numpy as np

from vmharness.explicit.model.state import Array
from vmharness.explicit.rigid.inertia import of_points


def rigid_motion(
    x: Array, v: Array, omega: Array, mass: Array, rotary: Array, at: Array
) -> tuple[Array, Array]:
    """Velocity (3,) of the place `at`, and angular velocity (3,), that keep momentum and angular momentum of points.

        v_c = sum m v / M        omega = I^-1 sum (r x m v + J omega_k)

    `x`, `v`, `omega` (m, 3); `mass`, `rotary` (m,). Points without any mass all count alike. A line of points takes
    no spin about itself.
    """
    weight = mass if mass.any() else np.ones_like(mass)
    inertia = of_points(x, weight, rotary)
    linear = weight @ v / inertia.mass
    momentum = np.cross(x - inertia.centre, weight[:, None] * v).sum(axis=0) + rotary @ omega
    spin = np.linalg.pinv(inertia.tensor, rcond=1e-12, hermitian=True) @ momentum
    return linear + np.cross(spin, at - inertia.centre), spin
