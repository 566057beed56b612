"""*LOAD_SEGMENT: pressure on segments, by a curve over time."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CORNERS = ("n1", "n2", "n3", "n4")

PRESSURE = {"lcid": integer(), "sf": real(1.0, zero_is_default=True), "at": real(0.0)}

LOAD_SEGMENT = Keyword(
    "LOAD_SEGMENT",
    Card({**PRESSURE, **dict.fromkeys(CORNERS, integer(above=0)), "n5": integer(0)}),
    Card({name: integer(0) for name in ("n6", "n7", "n8")}, when=lambda entry: entry.n5 != 0),
    options=("ID",),
    repeat=True,
)

LOAD_SEGMENT_SET = Keyword(
    "LOAD_SEGMENT_SET", Card({"ssid": integer(above=0), **PRESSURE}), options=("ID",), repeat=True
)
