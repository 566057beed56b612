"""*ELEMENT_BEAM: beams and trusses of two nodes; a third, or a vector, turns the cross-section about the axis."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real
from vmharness.deck.keyword import Keyword

ID = integer(width=8, above=0)
CORNERS = ("n1", "n2")
NODES: dict[str, Field] = {"eid": ID, "pid": ID, **dict.fromkeys(CORNERS, ID)}
RELEASES: dict[str, Field] = {name: integer(0, width=8) for name in ("rt1", "rr1", "rt2", "rr2")}
LOCAL = integer(2, width=8)  # the frame of releases

ELEMENT_BEAM = Keyword(
    "ELEMENT_BEAM",
    Card({**NODES, "n3": integer(0, width=8), **RELEASES, "local": LOCAL}),
    table=True,
    unique="eid",
    kind="beam element",
    corners=CORNERS,
)

ELEMENT_BEAM_ORIENTATION = Keyword(
    "ELEMENT_BEAM_ORIENTATION",
    Card({**NODES, "n3": integer(0, width=8), **RELEASES, "local": LOCAL}),
    Card(vx=real(0.0), vy=real(0.0), vz=real(0.0)),
    table=True,
    unique="eid",
    kind="beam element",
    corners=CORNERS,
)
