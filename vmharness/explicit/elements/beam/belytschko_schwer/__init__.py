"""Belytschko-Schwer beam (*SECTION_BEAM ELFORM = 2): two nodes, linear elastic resultants, exact cubic bending.

The element measures small deformations in a large motion. Each end carries two unit vectors s and t that rotate
with its node; r is the unit vector from node 1 to node 2. Seven measures of deformation vanish for every rigid motion:

    elongation          L - L_0
    twist               phi     = asin (s_2 . t_1 - t_2 . s_1) / 2
    rotation about s    theta_s = asin  r . t             at each end, against the chord
    rotation about t    theta_t = asin -r . s             at each end, against the chord

The energy is quadratic in these measures and exact for cubic bending (stiffness.py); forces and moments are its
gradient (step.py). They are therefore conservative and in equilibrium, and vanish for every rigid motion, however
large. In plane bending theta is the angle itself: a straight beam under an end moment bends to an exact circle.
Rotations against the chord must be below 90 degrees in each element, and are assumed to be small.

Source: T. Belytschko, L. Schwer, M. J. Klein, Large displacement, transient analysis of space frames, International
Journal for Numerical Methods in Engineering 11 (1977) 65-84; J. O. Hallquist, LS-DYNA Theory Manual,
Belytschko-Schwer beam. Their measures are components of the nodal triads in the triad of the element; those here agree
with them for small deformations.

    stiffness.py   constants of the energy, shear flexibility
    inertia.py     lumped mass and rotary inertia, stable step
    step.py        one step of many elements
    part.py        the beams of a part as a force, and from the deck
"""

from vmharness.explicit.elements.beam.belytschko_schwer.part import BelytschkoSchwer, build

NAME = "Belytschko-Schwer beam"

__all__ = ["NAME", "BelytschkoSchwer", "build"]
