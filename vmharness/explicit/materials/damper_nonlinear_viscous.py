"""*MAT_DAMPER_NONLINEAR_VISCOUS (S05): a nonlinear dashpot: force over the rate of elongation by a curve.

The rate is half a step old, as in the linear dashpot: the motion is of first order in dt.
"""

from typing import NamedTuple

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.damper_nonlinear_viscous import MAT_DAMPER_NONLINEAR_VISCOUS
from vmharness.deck.rule import above
from vmharness.deck.support import supports
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._characteristic import Characteristic, characteristic, ordinate, steepest
from vmharness.explicit.state import Array

SUPPORTS = (supports(MAT_DAMPER_NONLINEAR_VISCOUS, lcdr=above(0)),)

KEYWORD = MAT_DAMPER_NONLINEAR_VISCOUS
HISTORY = {"spring": 0}


class NonlinearDamper(NamedTuple):
    """Force over the rate of elongation."""

    curve: Characteristic


def constants(deck: Deck, entry: Entry) -> NonlinearDamper:
    """The curve LCDR; raises DeckError unless it passes through the origin."""
    return NonlinearDamper(characteristic(deck, entry, "lcdr"))


def bounds(constants: NonlinearDamper) -> tuple[float, float]:
    """No stiffness, the steepest slope of the curve as damping."""
    return 0.0, steepest(constants.curve)


@inlined
def spring(
    constants: NonlinearDamper,
    dt: float,
    elongation: float,
    rate: float,
    history: Array,
    at: int,
    stride: int,
) -> float:
    """f = LCDR(ddot)."""
    return ordinate(constants.curve, rate)
