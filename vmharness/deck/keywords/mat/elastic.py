"""*MAT_ELASTIC (001): linear elasticity, isotropic."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, skip, text
from vmharness.deck.keyword import Keyword

MAT_ELASTIC = Keyword(
    "MAT_ELASTIC",
    Card(
        mid=integer(above=0),
        ro=real(),
        e=real(),
        pr=real(0.0),
        da=real(0.0),
        db=real(0.0),
        _7=skip(),
        _8=skip(),
    ),
    Card(efunc=text("P"), cnvt=real(0.001), iterlm=integer(3), when=lambda entry: entry.e < 0.0),
    aliases=("MAT_001",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
