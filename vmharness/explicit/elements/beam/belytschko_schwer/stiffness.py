"""Stiffness of a beam's deformations: the exact one of a beam loaded at its ends.

    energy = 1/2 [EA/L (elongation)^2 + GJ/L phi^2 + sum over s, t of a (theta_1^2 + theta_2^2) + 2 b theta_1 theta_2]

    a = (4 + Phi) EI / (L (1 + Phi)),   b = (2 - Phi) EI / (L (1 + Phi)),   Phi = 12 EI / (G A_s L^2)

I = I_ss for rotations about s, I_tt about t. Without a shear area A_s there is no shear flexibility: Phi = 0
(J. S. Przemieniecki, Theory of Matrix Structural Analysis, section 5.6).
"""

from dataclasses import dataclass

import numpy as np

from vmharness.explicit.state import Array

AXIAL, TORSION, S_NEAR, S_FAR, T_NEAR, T_FAR = range(6)  # EA/L, GJ/L, a and b about s, a and b about t


@dataclass(frozen=True)
class CrossSection:
    """Area, moments of area about s and t, torsion constant, shear area (0: rigid in shear); consistent units."""

    a: float
    iss: float
    itt: float
    j: float
    sa: float = 0.0


def stiffness(length: Array, section: CrossSection, e: float, nu: float) -> Array:
    """Constants (ne, 6) of the energy, in the order above, for beams of `length` (ne,).

    >>> stiffness(np.array([2.0]), CrossSection(a=3.0, iss=1.0, itt=2.0, j=4.0), e=10.0, nu=0.25)
    array([[15.,  8., 20., 10., 40., 20.]])
    """
    g = e / (2 * (1 + nu))
    constants = [e * section.a / length, g * section.j / length]
    for moment in (section.iss, section.itt):
        phi = 12 * e * moment / (g * section.sa * length**2) if section.sa else 0.0
        constants += [
            (4 + phi) * e * moment / (length * (1 + phi)),
            (2 - phi) * e * moment / (length * (1 + phi)),
        ]
    return np.stack(constants, axis=1)
