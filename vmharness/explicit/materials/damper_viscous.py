"""*MAT_DAMPER_VISCOUS (S02): a linear dashpot: force proportional to the rate of elongation.

The rate is that of the step that led to t_n, half a step old: f_n = C ddot_{n-1/2}. The motion is therefore of first
order in dt, with an error of about C dt/(2 m) of the damped part.
"""

from typing import NamedTuple

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.deck.rule import at_least
from vmharness.deck.support import supports
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.state import Array

SUPPORTS = (supports(MAT_DAMPER_VISCOUS, dc=at_least(0.0)),)

KEYWORD = MAT_DAMPER_VISCOUS
HISTORY = {"spring": 0}


class ViscousDamper(NamedTuple):
    """Damping coefficient."""

    C: float


def constants(deck: Deck, entry: Entry) -> ViscousDamper:
    """The damping coefficient C."""
    return ViscousDamper(entry.dc)


def bounds(constants: ViscousDamper) -> tuple[float, float]:
    """No stiffness, damping C."""
    return 0.0, constants.C


@inlined
def spring(
    constants: ViscousDamper, dt: float, elongation: float, rate: float, history: Array, at: int, stride: int
) -> float:
    """f = C ddot."""
    return constants.C * rate
