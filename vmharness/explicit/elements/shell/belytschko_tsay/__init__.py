"""Belytschko-Tsay shell (ELFORM 2): four nodes, one point in the plane, NIP points through the thickness.

Source: T. Belytschko, J. I. Lin, C. S. Tsay, Explicit algorithms for the nonlinear dynamics of shells, Computer
Methods in Applied Mechanics and Engineering 42 (1984) 225-251; J. O. Hallquist, LS-DYNA Theory Manual,
Belytschko-Lin-Tsay shell.

    frame.py      the element's axes, area, gradient operator B and hourglass projection gamma
    rates.py      strain and hourglass increments, on the geometry at mid-step
    forces.py     nodal forces and moments, on the geometry at the end of the step
    hourglass.py  moduli of the viscous and the stiffness form
    mass.py       area, lumped mass and rotary inertia
    length.py     characteristic length of the stable step
    step.py       the stages of a step of many elements; kernels/simd.py: their corners in its buffer
    part.py       the shells of a part as a force; build.py: from the deck

What it shares with the triangle is in explicit/shell: the law at points through the thickness, the order of a step.
It has no stiffness against warping and none about its normal (drilling), and it is exact for a constant membrane strain
in any shape, for constant curvature in parallelograms only.
"""

from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import Hourglass
from vmharness.explicit.elements.shell.belytschko_tsay.mass import nodal_mass
from vmharness.explicit.elements.shell.belytschko_tsay.part import BelytschkoTsay, build

NAME = "Belytschko-Tsay shell"

__all__ = ["NAME", "BelytschkoTsay", "Hourglass", "build", "nodal_mass"]
