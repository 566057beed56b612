"""*RIGIDWALL_PLANAR with _FINITE, _MOVING and both; options of the name may stand in either order."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword

NODES = Card(
    nsid=integer(0),
    nsidex=integer(0),
    boxid=integer(0),
    offset=real(0.0),
    birth=real(0.0),
    death=real(1e20, zero_is_default=True),
    rwksf=real(1.0),  # scales the penalty of rigid bodies
)

PLANE = Card(
    xt=real(0.0), yt=real(0.0), zt=real(0.0), xh=real(0.0), yh=real(0.0), zh=real(0.0),
    fric=real(0.0), wvel=real(0.0),
)  # fmt: skip

EDGES = Card(xhev=real(0.0), yhev=real(0.0), zhev=real(0.0), lenl=real(), lenm=real())

MOTION = Card(mass=real(), v0=real(0.0))


def _keyword(name: str, *cards: Card, aliases: tuple[str, ...] = ()) -> Keyword:
    options = {"ID": Card(id=integer(0), heading=text("", width=70))}
    return Keyword(f"RIGIDWALL_PLANAR{name}", NODES, PLANE, *cards, options=options, aliases=aliases)


KEYWORDS = (
    _keyword(""),
    _keyword("_FINITE", EDGES),
    _keyword("_MOVING", MOTION),
    _keyword("_FINITE_MOVING", EDGES, MOTION, aliases=("RIGIDWALL_PLANAR_MOVING_FINITE",)),
)
