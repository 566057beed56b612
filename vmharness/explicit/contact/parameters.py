"""How a contact acts: the options of cards 1 to 3, A and C that its mechanics need."""

from dataclasses import dataclass
from typing import Literal

import numpy as np


@dataclass(frozen=True)
class Options:
    """Options of one contact, by their names in the deck; consistent units."""

    soft: Literal[0, 1] = 0
    sofscl: float = 0.1
    fs: float = 0.0  # static and kinetic friction, mu = FD + (FS - FD) exp(-DC |v|)
    fd: float = 0.0
    dc: float = 0.0
    vc: float = np.inf  # largest shear stress, infinity where VC = 0
    vdc: float = 0.0  # percent of critical damping
    bt: float = 0.0  # birth and death
    dt: float = 1e20
    maxpar: float = (
        1.025  # a segment reaches this far in xi and eta, so that nothing slips through between two
    )
    ignore: bool = False  # an initial penetration is kept as an offset of the gap
