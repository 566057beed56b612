"""*MAT_SPRING_NONLINEAR_ELASTIC (S04): a spring with a curve of force over elongation.

Loading and unloading follow the same curve.

LCR is not supported. It is described as a factor of the force over the rate, with a curve through (0, 0); a spring at
rest would then have no force. What LS-DYNA does is not established.
"""

from typing import NamedTuple

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.spring_nonlinear_elastic import MAT_SPRING_NONLINEAR_ELASTIC
from vmharness.deck.rule import above, only
from vmharness.deck.support import supports
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._characteristic import Characteristic, characteristic, ordinate, steepest
from vmharness.explicit.state import Array

SUPPORTS = (supports(MAT_SPRING_NONLINEAR_ELASTIC, lcd=above(0), lcr=only(0)),)

KEYWORD = MAT_SPRING_NONLINEAR_ELASTIC
HISTORY = {"spring": 0}


class NonlinearSpring(NamedTuple):
    """Force over elongation."""

    curve: Characteristic


def constants(deck: Deck, entry: Entry) -> NonlinearSpring:
    """The curve LCD; raises DeckError unless it passes through the origin."""
    return NonlinearSpring(characteristic(deck, entry, "lcd"))


def bounds(constants: NonlinearSpring) -> tuple[float, float]:
    """The steepest slope of the curve, no damping."""
    return steepest(constants.curve), 0.0


@inlined
def spring(
    constants: NonlinearSpring,
    dt: float,
    elongation: float,
    rate: float,
    history: Array,
    at: int,
    stride: int,
) -> float:
    """f = LCD(d)."""
    return ordinate(constants.curve, elongation)
