"""Hourglass control: resistance to the five patterns that have no strain at the one point in the plane.

Stiffness form (IHQ 4, 5, 6; Belytschko, Lin, Tsay 1984; Hallquist, LS-DYNA Theory Manual, Belytschko-Lin-Tsay
shell): forces Q conjugate to the rates q grow as dQ/dt = C q with

    membrane  C = QM E t A (B.B) / 8,   warping  C = QW kappa G t^3 (B.B) / 12,   bending  C = QB E t^3 A (B.B) / 192

and B.B the sum over all B_aI^2. C is that of the initial geometry, so that the stored energy is sum Q^2 / 2C.

Viscous form (IHQ 1, 2, 3): Q = c q. LS-DYNA's constants are not published. Here c is the fraction QM, QW or QB of the
critical damping of the pattern on the stiffness C of coefficient 1. A node's share n of the mass (of the inertia, for
bending) moves in the pattern as n dv/dt = -4 (C int v dt + c v), so c = Q sqrt(n C). On a square that is

    membrane  c = QM rho c0 t sqrt(A) / 4,   warping  c = QW rho c0 t^2 sqrt(kappa / (3 (1 + nu))) / 4,
    bending   c = QB rho c0 t^2 A / (32 sqrt 3),   c0 = sqrt(E / rho)

(nu >= 0.2 for the last). The first is that of Flanagan and Belytschko for solids; Radioss has the form of all three.
"""

from dataclasses import dataclass

import numpy as np

from vmharness.explicit.elements.shell.belytschko_tsay.mass import nodal_mass
from vmharness.explicit.materials import Moduli
from vmharness.explicit.state import Array


@dataclass(frozen=True)
class Hourglass:
    """Control type IHQ (1-3 viscous, 4-6 stiffness) and coefficients for membrane, bending, warping."""

    ihq: int = 2
    qm: float = 0.1
    qb: float = 0.1
    qw: float = 0.1

    def __post_init__(self) -> None:
        if self.ihq not in (1, 2, 3, 4, 5, 6):
            raise ValueError(f"IHQ = {self.ihq}: shells know 1, 2, 3 (viscous) and 4, 5, 6 (stiffness)")

    @property
    def viscous(self) -> bool:
        """Whether forces are proportional to the rates, not to the displacements."""
        return self.ihq <= 3


def moduli(
    x: Array,
    thickness: Array,
    density: float,
    elastic: Moduli,
    shrf: float,
    control: Hourglass,
) -> Array:
    """Membrane, warping and bending constants (3, ne): C of the stiffness form, c of the viscous form.

    `x (ne, 4, 3)`: corners; `thickness (ne,)`. Consistent units.
    """
    E, nu = elastic
    t, G = thickness, E / (2 * (1 + nu))
    r13, r24 = x[:, 0] - x[:, 2], x[:, 1] - x[:, 3]
    A = 0.5 * np.linalg.norm(np.cross(r13, r24), axis=1)
    BB = (np.sum(r13**2, axis=1) + np.sum(r24**2, axis=1)) / (2 * A**2)
    C = np.stack([E * t * A * BB / 8, shrf * G * t**3 * BB / 12, E * t**3 * A * BB / 192])
    Q = np.array([[control.qm], [control.qw], [control.qb]])
    if not control.viscous:
        return Q * C
    mass, inertia = nodal_mass(x, thickness, density, nu, shrf)
    return Q * np.sqrt(np.stack([mass, mass, inertia]) * C)
