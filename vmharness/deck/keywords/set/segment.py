"""*SET_SEGMENT: faces of four nodes; a triangle repeats its third."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword

SET_SEGMENT = Keyword(
    "SET_SEGMENT",
    Card(
        sid=integer(above=0),
        da1=real(0.0),
        da2=real(0.0),
        da3=real(0.0),
        da4=real(0.0),
        solver=text("MECH", capitals=True),
        its=integer(0),
    ),
    Rows(
        n1=integer(above=0),
        n2=integer(above=0),
        n3=integer(above=0),
        n4=integer(above=0),
        a1=real(0.0),
        a2=real(0.0),
        a3=real(0.0),
        a4=real(0.0),
    ),
    options=("TITLE",),
    unique="sid",
    kind="segment set",
)
