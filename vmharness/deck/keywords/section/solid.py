"""*SECTION_SOLID: formulation of solids."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, skip
from vmharness.deck.keyword import Keyword

SECTION_SOLID = Keyword(
    "SECTION_SOLID",
    Card(
        secid=integer(above=0),
        elform=integer(1, zero_is_default=True),
        aet=integer(0),
        _4=skip(),
        _5=skip(),
        _6=skip(),
        cohoff=real(0.0),
        gaskett=real(0.0),
    ),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
