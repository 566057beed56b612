"""*MAT_DAMPER_VISCOUS (S02): a linear dashpot."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

MAT_DAMPER_VISCOUS = Keyword(
    "MAT_DAMPER_VISCOUS",
    Card(mid=integer(above=0), dc=real()),
    aliases=("MAT_S02",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
