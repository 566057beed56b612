"""*MAT_ELASTIC (001): linear elasticity, isotropic."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real, skip
from vmharness.deck.keyword import Keyword

MAT_ELASTIC = Keyword(
    "MAT_ELASTIC",
    Card(
        mid=integer(above=0),
        ro=real(above=0.0),
        e=real(above=0.0),
        pr=real(0.0),
        da=only(0.0),
        db=only(0.0),
        _7=skip(),
        _8=skip(),
    ),
    aliases=("MAT_001",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
