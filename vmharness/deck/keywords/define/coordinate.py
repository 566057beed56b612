"""*DEFINE_COORDINATE, *DEFINE_VECTOR and *DEFINE_BOX: systems, directions and regions that other cards name."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real, text
from vmharness.deck.keyword import Keyword


def _reals(names: str) -> dict[str, Field]:
    return {name: real(0.0) for name in names.split()}


def _coordinate(name: str, *cards: Card) -> Keyword:
    return Keyword(
        f"DEFINE_COORDINATE_{name}", *cards, options=("TITLE",), unique="cid", kind="coordinate system"
    )


DEFINE_COORDINATE_SYSTEM = _coordinate(
    "SYSTEM",
    Card({"cid": integer(above=0), **_reals("xo yo zo xl yl zl")}, cidl=integer(0)),
    Card(_reals("xp yp zp"), type=integer(0)),
)

DEFINE_COORDINATE_VECTOR = _coordinate(
    "VECTOR", Card({"cid": integer(above=0), **_reals("xx yx zx xv yv zv")}, nid=integer(0))
)

DEFINE_COORDINATE_NODES = _coordinate(
    "NODES",
    Card(
        cid=integer(above=0),
        n1=integer(above=0),
        n2=integer(above=0),
        n3=integer(above=0),
        flag=integer(0),
        dir=text("X"),
        type=integer(0),
    ),
)

DEFINE_VECTOR = Keyword(
    "DEFINE_VECTOR",
    Card({"vid": integer(above=0), **_reals("xt yt zt xh yh zh")}, cid=integer(0)),
    repeat=True,
    options=("TITLE",),
    unique="vid",
    kind="vector",
)

DEFINE_BOX = Keyword(
    "DEFINE_BOX",
    Card({"boxid": integer(above=0), **_reals("xmn xmx ymn ymx zmn zmx")}),
    options=("TITLE",),
    unique="boxid",
    kind="box",
)
