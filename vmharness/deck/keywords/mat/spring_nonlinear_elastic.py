"""*MAT_SPRING_NONLINEAR_ELASTIC (S04): a spring with a curve of force over elongation."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

MAT_SPRING_NONLINEAR_ELASTIC = Keyword(
    "MAT_SPRING_NONLINEAR_ELASTIC",
    Card(mid=integer(above=0), lcd=integer(), lcr=integer(0)),
    aliases=("MAT_S04",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
