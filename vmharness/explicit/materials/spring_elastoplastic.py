"""*MAT_SPRING_ELASTOPLASTIC (S03): stiffness K up to the force FY, then KT, with isotropic hardening.

With d_p the plastic elongation and p the sum of its magnitudes,

    f = K (d - d_p)        |f| <= FY + H p        H = K KT/(K - KT)

A force K (d - d_p) beyond the yield force is returned to it by the plastic elongation (|f| - FY - H p)/(K + H) in
its direction. This is exact for a step of any size, since the path of a spring has one direction.
"""

from typing import NamedTuple

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.mat.spring_elastoplastic import MAT_SPRING_ELASTOPLASTIC
from vmharness.deck.rule import above, at_least
from vmharness.deck.support import supports
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.state import Array

SUPPORTS = (supports(MAT_SPRING_ELASTOPLASTIC, k=above(0.0), kt=at_least(0.0), fy=above(0.0)),)

KEYWORD = MAT_SPRING_ELASTOPLASTIC
HISTORY = {"spring": 2}  # d_p, p


class ElastoplasticSpring(NamedTuple):
    """Stiffness, yield force and hardening K KT / (K - KT)."""

    K: float
    FY: float
    H: float


def constants(deck: Deck, entry: Entry) -> ElastoplasticSpring:
    """K, FY and H; raises DeckError unless KT < K."""
    if not entry.kt < entry.k:
        raise entry.error("kt", f"must be less than K = {entry.k:g}")
    return ElastoplasticSpring(entry.k, entry.fy, entry.k * entry.kt / (entry.k - entry.kt))


def bounds(constants: ElastoplasticSpring) -> tuple[float, float]:
    """The elastic stiffness K, no damping."""
    return constants.K, 0.0


@inlined
def spring(
    constants: ElastoplasticSpring,
    dt: float,
    elongation: float,
    rate: float,
    history: Array,
    at: int,
    stride: int,
) -> float:
    """f = K (d - d_p) after the return to |f| = FY + H p."""
    k, fy, hardening = constants.K, constants.FY, constants.H
    trial = k * (elongation - history[at])
    excess = abs(trial) - fy - hardening * history[at + stride]
    if excess <= 0.0:
        return trial
    plastic = excess / (k + hardening)
    direction = 1.0 if trial > 0.0 else -1.0
    history[at] += direction * plastic
    history[at + stride] += plastic
    return trial - direction * k * plastic
