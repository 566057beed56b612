"""*SET_SOLID, *SET_BEAM and *SET_DISCRETE: elements by list."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import integer, text
from vmharness.deck.keyword import Keyword

SET_SOLID = Keyword(
    "SET_SOLID",
    Card(sid=integer(above=0), solver=text("MECH", capitals=True), its=text("0")),
    Rows(per_line=8, solids=integer(0)),
    options=("TITLE",),
    unique="sid",
    kind="solid set",
)

SET_BEAM = Keyword(
    "SET_BEAM",
    Card(sid=integer(above=0)),
    Rows(per_line=8, beams=integer(0)),
    options=("TITLE",),
    unique="sid",
    kind="beam set",
)

SET_DISCRETE = Keyword(
    "SET_DISCRETE",
    Card(sid=integer(above=0)),
    Rows(per_line=8, springs=integer(0)),
    options=("TITLE",),
    unique="sid",
    kind="set of discrete elements",
)
