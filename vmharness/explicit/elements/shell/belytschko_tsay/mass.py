"""Lumped mass and rotary inertia of a shell's nodes."""

import numpy as np

from vmharness.explicit.elements.shell._parts import area
from vmharness.explicit.state import Array


def nodal_mass(x: Array, thickness: Array, density: float, nu: float, shrf: float) -> tuple[Array, Array]:
    """Mass and rotary inertia (ne,), (ne,) that an element gives to each of its nodes.

        m = rho t A / 4,   I = m max(t^2/12, A/8, A s / (8 (1 + |nu|) - 4 s)),   s = kappa (1 - nu)

    t^2/12 is the inertia of the plate itself; a larger one serves the stable step of L/c only. A/8 (Hughes, Cohen,
    Haroun 1978) is enough inside a mesh. At free edges it is not: transverse shear of a free square of side L has
    omega^2 = kappa G / (rho L^2) (4 + A m/I), its membrane 4 (1 + |nu|) (c/L)^2. The last term keeps the first below
    the second, so that rotation never limits the step. It governs for nu < 0.2 only (A/4 at nu = 0, kappa = 1).

    The inertia lowers a plate's frequency by the fraction k^2 I / 2m for wave number k: 0.3 % for the first mode of a
    simply supported square plate of 20 x 20 elements at A/8.

    `x (ne, 4, 3)`: corners; `thickness (ne,)`; `nu`: Poisson's ratio; `shrf`: shear factor kappa. Consistent units.
    """
    A = area(x)
    s = shrf * (1 - nu)
    mass = density * thickness * A / 4
    return mass, mass * np.maximum(thickness**2 / 12, A * max(1 / 8, s / (8 * (1 + abs(nu)) - 4 * s)))
