"""*MAT_SPRING_ELASTOPLASTIC (S03): a spring with yield force and isotropic hardening."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

MAT_SPRING_ELASTOPLASTIC = Keyword(
    "MAT_SPRING_ELASTOPLASTIC",
    Card(mid=integer(above=0), k=real(), kt=real(0.0), fy=real()),
    aliases=("MAT_S03",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
