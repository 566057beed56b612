"""Lumped mass and rotary inertia of a triangle's nodes."""

import numpy as np

from vmharness.explicit.elements.shell._parts import area
from vmharness.explicit.state import Array


def nodal_mass(x: Array, thickness: Array, density: float, nu: float, shrf: float) -> tuple[Array, Array]:
    """Mass and rotary inertia (ne,), (ne,) that an element gives to each of its nodes.

        m = rho t A / 3,   I = m (t^2/12 + 2/9 L^2 s / (2 (1 + |nu|) - s)),   s = kappa (1 - nu)

    with L the longest side. t^2/12 is the inertia of the plate itself; the rest serves the stable step only: the
    frequency of the shear of a free element is below that of its membrane, so that rotation never limits the step.
    The equilateral triangle with nu >= 0 would need 5/24 L^2 in place of 2/9 L^2, other shapes less.

    `x (ne, 3, 3)`: corners; `thickness (ne,)`; `nu`: Poisson's ratio; `shrf`: shear factor kappa. Consistent units.
    """
    longest = np.linalg.norm(x - np.roll(x, 1, axis=1), axis=2).max(axis=1)
    s = shrf * (1 - nu)
    mass = density * thickness * area(x) / 3
    return mass, mass * (thickness**2 / 12 + 2 / 9 * longest**2 * s / (2 * (1 + abs(nu)) - s))
