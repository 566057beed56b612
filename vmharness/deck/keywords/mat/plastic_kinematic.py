"""*MAT_PLASTIC_KINEMATIC (003): bilinear plasticity with isotropic, kinematic or mixed hardening."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

MAT_PLASTIC_KINEMATIC = Keyword(
    "MAT_PLASTIC_KINEMATIC",
    Card(
        mid=integer(above=0),
        ro=real(),
        e=real(),
        pr=real(0.0),
        sigy=real(),
        etan=real(0.0),
        beta=real(0.0),
    ),
    Card(
        src=real(0.0),
        srp=real(0.0),
        fs=real(0.0),
        vp=real(0.0),
    ),
    aliases=("MAT_003",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
