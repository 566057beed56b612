"""A nonlinear dashpot: force over the rate of elongation by a curve.

The rate is half a step old, as in the linear dashpot: the motion is accurate to the first order in dt.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.damper_nonlinear_viscous import MAT_DAMPER_NONLINEAR_VISCOUS
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.characteristic import Characteristic, characteristic, ordinate, steepest
from vmharness.explicit.model.state import Array

KEYWORD = MAT_DAMPER_NONLINEAR_VISCOUS

HISTORY = {"spring": 0}


def constants(deck: Deck, entry: Entry) -> Characteristic:
    """The curve LCDR; raises DeckError unless it passes through the origin."""
    return characteristic(deck, entry, "lcdr")


def bounds(constants: Characteristic) -> tuple[float, float]:
    """No stiffness, the steepest slope of the curve as damping."""
    return 0.0, steepest(constants)


@inlined
def spring(
    constants: Characteristic, dt: float, elongation: float, rate: float, history: Array, at: int, stride: int
) -> float:
    """f = LCDR(ddot)."""
    return ordinate(constants, rate)
