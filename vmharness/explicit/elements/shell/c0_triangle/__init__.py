"""C0 triangle for triangular shells: three nodes, one point in the plane, NIP points through the thickness.

Source: J. M. Kennedy, T. Belytschko, J. I. Lin, Recent developments in explicit finite element techniques and their
application to reactor structures, Nuclear Engineering and Design 96 (1986) 1-24; J. O. Hallquist, LS-DYNA Theory
Manual, C0 triangular shell. LS-DYNA sorts triangles among shells of ELFORM 2 into this element (its ELFORM 4) if
*CONTROL_SHELL ESORT = 1, and takes a quadrilateral with two nodes in one place if ESORT = 0. Here both give this
element.

    frame.py      the element's axes, area, gradients, and the terms of the shear by curvature
    rates.py      strain increments, on the geometry at mid-step
    forces.py     nodal forces and moments, on the geometry at the end of the step
    mass.py       area, lumped mass and rotary inertia
    length.py     characteristic length of the stable step
    step.py       the stages of a step of many elements; kernels/simd.py: their corners in its buffer
    part.py       the shells of a part as a force; build.py: from the deck

Exact for a constant membrane strain and for constant curvature, in any mesh. Its membrane is the constant strain
triangle, stiff in bending in its plane. It has no stiffness about its normal (drilling), and of 18 motions one more is
free beside rigid ones and those: normals that turn as omega = c (x, y, 0) about the centre. Neighbours do not share it.
"""

from vmharness.explicit.elements.shell.c0_triangle.mass import nodal_mass
from vmharness.explicit.elements.shell.c0_triangle.part import C0Triangle, build

NAME = "C0 triangle"

__all__ = ["NAME", "C0Triangle", "build", "nodal_mass"]
