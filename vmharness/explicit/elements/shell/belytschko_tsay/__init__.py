"""Belytschko-Tsay shell (ELFORM 2): four nodes, one point in the plane, NIP points through the thickness.

Source: T. Belytschko, J. I. Lin, C. S. Tsay, Explicit algorithms for the nonlinear dynamics of shells, Computer
Methods in Applied Mechanics and Engineering 42 (1984) 225-251; J. O. Hallquist, LS-DYNA Theory Manual,
Belytschko-Lin-Tsay shell.

    frame.py      axes of the element, area, gradient operator B and hourglass projection gamma
    strain.py     strain and hourglass increments, and their transpose: nodal forces and moments
    hourglass.py  moduli of the viscous and of the stiffness form
    mass.py       lumped mass and rotary inertia
    length.py     characteristic length of the stable step
    step.py       the stages of a step of many elements
    part.py       the shells of a part as a force, and from the deck

The element has no stiffness against warping and none about its normal (drilling). It is exact for a constant membrane
strain in any shape, and for a constant curvature in parallelograms only.
"""

from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import Hourglass
from vmharness.explicit.elements.shell.belytschko_tsay.mass import nodal_mass
from vmharness.explicit.elements.shell.belytschko_tsay.part import BelytschkoTsay, build

NAME = "Belytschko-Tsay shell"

__all__ = ["NAME", "BelytschkoTsay", "Hourglass", "build", "nodal_mass"]
