"""C0 triangle for triangular shells: three nodes, one point in the plane, NIP points through the thickness.

Source: J. M. Kennedy, T. Belytschko, J. I. Lin, Recent developments in explicit finite element techniques and their
application to reactor structures, Nuclear Engineering and Design 96 (1986) 1-24; J. O. Hallquist, LS-DYNA Theory
Manual, C0 triangular shell. LS-DYNA sorts triangles among shells of ELFORM 2 into this element (its ELFORM 4) if
*CONTROL_SHELL ESORT = 1, and takes a quadrilateral with two nodes in one place if ESORT = 0. Here both cases
give this element.

    frame.py      axes of the element, area, gradients, and the terms of the shear by curvature
    strain.py     strain increments, and their transpose: nodal forces and moments
    mass.py       lumped mass and rotary inertia
    length.py     characteristic length of the stable step
    step.py       the stages of a step of many elements
    part.py       the shells of a part as a force, and from the deck

The element is exact for a constant membrane strain and for a constant curvature, in any mesh. Its membrane is the
constant strain triangle, which is stiff in bending in its plane. It has no stiffness about its normal (drilling). One
more of its 18 motions, beside the rigid ones, has no stiffness: rotations omega = c (x, y, 0) about the centre. In a
mesh it is not free, since neighbours do not share it.
"""

from vmharness.explicit.elements.shell.c0_triangle.mass import nodal_mass
from vmharness.explicit.elements.shell.c0_triangle.part import C0Triangle, build

NAME = "C0 triangle"

__all__ = ["NAME", "C0Triangle", "build", "nodal_mass"]
