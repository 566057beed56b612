"""A linear dashpot: force proportional to the rate of elongation.

The rate is that of the step that has led to t_n, half a step old: f_n = C ddot_{n-1/2}. The motion is therefore
accurate to the first order in dt only, with an error of about C dt/(2 m) of the damped part.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.state import Array

KEYWORD = MAT_DAMPER_VISCOUS

HISTORY = {"spring": 0}


def constants(deck: Deck, entry: Entry) -> tuple[float]:
    """The damping coefficient C."""
    return (entry.dc,)


def bounds(constants: tuple[float]) -> tuple[float, float]:
    """No stiffness, damping C."""
    return 0.0, constants[0]


@inlined
def spring(
    constants: tuple[float], dt: float, elongation: float, rate: float, history: Array, at: int, stride: int
) -> float:
    """f = C ddot."""
    return constants[0] * rate
