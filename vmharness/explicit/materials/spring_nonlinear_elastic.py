"""A nonlinear elastic spring: force over elongation by a curve, the same in loading and unloading.

LCR is refused: it is said to be a factor of the force over the rate and to pass through (0, 0), by which a spring at
rest would bear nothing; how LS-DYNA means it is not established.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.spring_nonlinear_elastic import MAT_SPRING_NONLINEAR_ELASTIC
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.characteristic import Characteristic, characteristic, ordinate, steepest
from vmharness.explicit.model.state import Array

KEYWORD = MAT_SPRING_NONLINEAR_ELASTIC

HISTORY = {"spring": 0}


def constants(deck: Deck, entry: Entry) -> Characteristic:
    """The curve LCD; raises DeckError unless it passes through the origin."""
    return characteristic(deck, entry, "lcd")


def bounds(constants: Characteristic) -> tuple[float, float]:
    """The steepest slope of the curve, no damping."""
    return steepest(constants), 0.0


@inlined
def spring(
    constants: Characteristic, dt: float, elongation: float, rate: float, history: Array, at: int, stride: int
) -> float:
    """f = LCD(d)."""
    return ordinate(constants, elongation)
