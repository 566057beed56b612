"""*MAT_SPRING_ELASTIC (S01): a linear spring, its force proportional to the elongation."""

from typing import NamedTuple

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.spring_elastic import MAT_SPRING_ELASTIC
from vmharness.deck.rule import at_least
from vmharness.deck.support import supports
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.state import Array

SUPPORTS = (supports(MAT_SPRING_ELASTIC, k=at_least(0.0)),)

KEYWORD = MAT_SPRING_ELASTIC
HISTORY = {"spring": 0}


class ElasticSpring(NamedTuple):
    """Stiffness."""

    K: float


def constants(deck: Deck, entry: Entry) -> ElasticSpring:
    """The stiffness K."""
    return ElasticSpring(entry.k)


def bounds(constants: ElasticSpring) -> tuple[float, float]:
    """Stiffness K, no damping."""
    return constants.K, 0.0


@inlined
def spring(
    constants: ElasticSpring, dt: float, elongation: float, rate: float, history: Array, at: int, stride: int
) -> float:
    """f = K d."""
    return constants.K * elongation
