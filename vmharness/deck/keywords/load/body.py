"""*LOAD_BODY: acceleration or rotation of the base, and the parts that feel it."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real
from vmharness.deck.keyword import Keyword


def _keyword(axis: str, **centre: Field) -> Keyword:
    sf = real(1.0, zero_is_default=True)
    card = Card({"lcid": integer(), "sf": sf, "lciddr": integer(0), **centre, "cid": integer(0)})
    return Keyword(f"LOAD_BODY_{axis}", card)


LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z = (
    _keyword(axis, xc=real(0.0), yc=real(0.0), zc=real(0.0)) for axis in "XYZ"
)

LOAD_BODY_RX, LOAD_BODY_RY, LOAD_BODY_RZ = (
    _keyword(f"R{axis}", xc=real(0.0), yc=real(0.0), zc=real(0.0)) for axis in "XYZ"
)

LOAD_BODY_PARTS = Keyword("LOAD_BODY_PARTS", Card(psid=integer(above=0)), single=True)
