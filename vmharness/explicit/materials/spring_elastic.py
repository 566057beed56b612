"""A linear spring: force proportional to elongation.

Every law of springs and dampers has the signature of `spring` below, so that the element is written once for all:

    law(constants, dt, elongation, rate, history, at, stride) -> force

It takes one element at t_n: the elongation since the unloaded state, and the rate of elongation of the step dt that
led there; tension is positive. For a torsional element elongation is a rotation and force a moment. `constants` is
the tuple that the material makes once; the k-th history variable is `history[at + k * stride]`. `bounds` gives the
largest stiffness and the largest damping coefficient that the law can show, from which the stable step follows.
"""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.spring_elastic import MAT_SPRING_ELASTIC
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.state import Array

KEYWORD = MAT_SPRING_ELASTIC

HISTORY = {"spring": 0}


def constants(deck: Deck, entry: Entry) -> tuple[float]:
    """The stiffness K."""
    return (entry.k,)


def bounds(constants: tuple[float]) -> tuple[float, float]:
    """Stiffness K, no damping."""
    return constants[0], 0.0


@inlined
def spring(
    constants: tuple[float], dt: float, elongation: float, rate: float, history: Array, at: int, stride: int
) -> float:
    """f = K d."""
    return constants[0] * elongation
