"""*MAT_SPRING_ELASTIC (S01): a linear spring."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

MAT_SPRING_ELASTIC = Keyword(
    "MAT_SPRING_ELASTIC",
    Card(mid=integer(above=0), k=real()),
    aliases=("MAT_S01",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
