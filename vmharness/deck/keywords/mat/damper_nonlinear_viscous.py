"""*MAT_DAMPER_NONLINEAR_VISCOUS (S05): a dashpot with a curve of force over rate."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

MAT_DAMPER_NONLINEAR_VISCOUS = Keyword(
    "MAT_DAMPER_NONLINEAR_VISCOUS",
    Card(mid=integer(above=0), lcdr=integer()),
    aliases=("MAT_S05",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
