"""Solid of eight nodes with one point (ELFORM 1): constant stress, hourglass control.

Sources: D. P. Flanagan, T. Belytschko, A uniform strain hexahedron and quadrilateral with orthogonal hourglass control,
International Journal for Numerical Methods in Engineering 17 (1981) 679-706; J. O. Hallquist, LS-DYNA Theory Manual,
solid elements.

    hourglass.py   viscous and stiffness forms
    step.py        one step of many elements: motion, strain, stress, forces
    build.py       from the deck

The gradient is the mean over the volume, so that strain is exact for linear fields in any shape, and volume too. The
stress obeys the Jaumann rate.
"""

from vmharness.explicit.elements.solid.one_point.build import build
from vmharness.explicit.elements.solid.one_point.hourglass import Hourglass, moduli
from vmharness.explicit.elements.solid.one_point.step import step

NAME = "one-point hexahedron"

__all__ = ["NAME", "Hourglass", "build", "moduli", "step"]
