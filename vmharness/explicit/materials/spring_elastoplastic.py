"""An elastoplastic spring: stiffness K up to the force FY, then KT, with isotropic hardening.

With d_p the plastic elongation and p the sum of its magnitudes,

    f = K (d - d_p)        |f| <= FY + H p        H = K KT/(K - KT)

A force K (d - d_p) beyond the yield force is returned to it by the plastic elongation (|f| - FY - H p)/(K + H) in
its direction: exact for any size of step, since the path of a spring has no other direction.
"""

from vmharness.deck import Card, Deck, Entry, Keyword, integer, real
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.model.state import Array

KEYWORD = Keyword(
    "MAT_SPRING_ELASTOPLASTIC",
    Card(mid=integer(above=0), k=real(above=0.0), kt=real(0.0, at_least=0.0), fy=real(above=0.0)),
    aliases=("MAT_S03",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)

HISTORY = {"spring": 2}  # d_p, p


def constants(deck: Deck, entry: Entry) -> tuple[float, float, float]:
    """K, FY and H; raises DeckError unless KT < K."""
    if not entry.kt < entry.k:
        raise entry.error("kt", f"must be less than K = {entry.k:g}")
    return entry.k, entry.fy, entry.k * entry.kt / (entry.k - entry.kt)


def bounds(constants: tuple[float, float, float]) -> tuple[float, float]:
    """The elastic stiffness K, no damping."""
    return constants[0], 0.0


@inlined
def spring(
    constants: tuple[float, float, float],
    dt: float,
    elongation: float,
    rate: float,
    history: Array,
    at: int,
    stride: int,
) -> float:
    """f = K (d - d_p) after the return to |f| = FY + H p."""
    k, fy, hardening = constants
    trial = k * (elongation - history[at])
    excess = abs(trial) - fy - hardening * history[at + stride]
    if excess <= 0.0:
        return trial
    plastic = excess / (k + hardening)
    direction = 1.0 if trial > 0.0 else -1.0
    history[at] += direction * plastic
    history[at + stride] += plastic
    return trial - direction * k * plastic
