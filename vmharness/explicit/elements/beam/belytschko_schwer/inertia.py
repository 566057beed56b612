"""Lumped mass and rotary inertia of a beam's nodes, and the step that they allow.

Each node has m = rho A L / 2 and an inertia m L^2 j, the same about every axis. With r^2 = max(I_ss, I_tt) / A,
q = (r/L)^2 and c = sqrt(E/rho), the free element has the highest frequencies

    axial     omega^2 = 4 (c/L)^2
    bending   omega^2 = (12 q / j + 48 q) (c/L)^2
    torsion   omega^2 = 4 (G/E) (J / (A L^2 j)) (c/L)^2

LS-DYNA's step is the smaller of L/c and 1/2 L / (c sqrt(3 I (3 / (12 I + A L^2) + 1 / (A L^2)))). The second is the
bending limit 2/omega for j = q + 1/12. The least inertia that keeps bending at or below LS-DYNA's step is

    j = 3 q / (1 - 12 q)   while L/c is the smaller,   else   j = q + 1/12

the smaller of the two; they are equal where the two limits are (L = 6.3 r). A slender beam thus gets 3 m r^2: three
times the inertia of the cross-section itself (Rayleigh), which lowers frequencies by the fraction k^2 r^2 3/2
for wave number k, and far less than m L^2 / 12. Torsional inertia is this too, not the polar moment of the section:
the speed of torsional waves is not physical.

The step is the smallest of the three; torsion governs only for torsion constants above the polar moment of the section.
It is a bound for every mesh, since the highest frequency is never above that of the stiffest element alone; L is the
current length where that is shorter. (Tension adds stiffness across the axis, of the order of the axial strain.)

Source for the step: J. O. Hallquist, LS-DYNA Theory Manual, time step of beams.
"""

import numpy as np

from vmharness.explicit.elements.beam.belytschko_schwer.stiffness import CrossSection
from vmharness.explicit.state import Array


def lumped(length: Array, section: CrossSection, density: float) -> tuple[Array, Array]:
    """Mass and rotary inertia (ne,), (ne,) of each of the two nodes of an element."""
    mass = 0.5 * density * section.a * length
    return mass, mass * length**2 * _inertia(_slenderness(length, section))


def stable_step(length: Array, section: CrossSection, e: float, nu: float, density: float) -> Array:
    """2 / omega_max (ne,) of the free elements, rigid in shear; consistent units."""
    q = _slenderness(length, section)
    j = _inertia(q)
    torsion = 4 / (2 * (1 + nu)) * section.j / (section.a * length**2 * j)
    highest = np.maximum(np.maximum(4.0, 12 * q / j + 48 * q), torsion)
    return np.asarray(2 * length / np.sqrt(highest * e / density))


def _slenderness(length: Array, section: CrossSection) -> Array:
    """q = I / (A L^2)."""
    return np.asarray(max(section.iss, section.itt) / (section.a * length**2))


def _inertia(q: Array) -> Array:
    """j = inertia / (m L^2)."""
    slender = np.divide(3 * q, 1 - 12 * q, out=np.full_like(q, np.inf), where=q < 1 / 12)
    return np.asarray(np.minimum(slender, q + 1 / 12))
