"""A nonlinear elastic spring: force over elongation by a curve, the same in loading and unloading.

LCR is refused: it is said to be a factor of the force over the rate and to pass through (0, 0), by which a spring at
rest would bear nothing; how LS-DYNA means it is not established.
"""

from typing import NamedTuple

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.spring_nonlinear_elastic import MAT_SPRING_NONLINEAR_ELASTIC
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.characteristic import Characteristic, characteristic, ordinate, steepest
from vmharness.explicit.model.state import Array

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
