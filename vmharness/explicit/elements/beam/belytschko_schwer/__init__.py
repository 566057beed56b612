"""Belytschko-Schwer beam (*SECTION_BEAM ELFORM = 2): two nodes, linear elastic resultants, exact cubic bending.

The element measures small deformations in a large motion. Each end carries two unit vectors s and t that turn with
its node; r is the unit vector from node 1 to node 2. Seven measures of deformation vanish for every rigid motion:

    elongation          L - L_0
    twist               phi     = asin (s_2 . t_1 - t_2 . s_1) / 2
    rotation about s    theta_s = asin  r . t             at each end, against the chord
    rotation about t    theta_t = asin -r . s             at each end, against the chord

The energy is that of a beam with exact cubic bending, quadratic in them (stiffness.py), and forces and moments are its
gradient (step.py). So they are conservative, balance each other and do not see rigid motions, however large. In
bending in a plane theta is the angle itself: a straight beam bends to a full circle under an end moment as it should.
Local rotations must stay below 90 degrees an element, and are supposed to be small.

Source: T. Belytschko, L. Schwer, M. J. Klein, Large displacement, transient analysis of space frames, International
Journal for Numerical Methods in Engineering 11 (1977) 65-84; J. O. Hallquist, LS-DYNA Theory Manual,
Belytschko-Schwer beam. They measure with components of nodal triads in the element's triad; the measures here agree
with those for small deformations.

    stiffness.py   constants of the energy, shear flexibility
    inertia.py     lumped mass and rotary inertia, stable step
    step.py        one step of many elements
    part.py        the beams of a part as a force; build.py: from the deck
"""

from vmharness.explicit.elements.beam.belytschko_schwer.part import BelytschkoSchwer, build

NAME = "Belytschko-Schwer beam"

__all__ = ["NAME", "BelytschkoSchwer", "build"]
