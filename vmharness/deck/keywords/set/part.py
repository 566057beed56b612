"""*SET_PART: parts by list."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword

SET_PART_LIST = Keyword(
    "SET_PART_LIST",
    Card(
        sid=integer(above=0),
        da1=real(0.0),
        da2=real(0.0),
        da3=real(0.0),
        da4=real(0.0),
        solver=text("MECH", capitals=True),
    ),
    Rows(per_line=8, parts=integer(0)),
    aliases=("SET_PART",),
    options=("TITLE",),
    unique="sid",
    kind="part set",
)
