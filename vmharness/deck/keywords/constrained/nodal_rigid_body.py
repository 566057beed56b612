"""*CONSTRAINED_NODAL_RIGID_BODY and _INERTIA: nodes that move as one rigid body, with a part number of its own."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords._inertia import CENTRE, LOCAL, TENSOR, VELOCITY

BODY: dict[str, Field] = {
    "pid": integer(above=0),
    "cid": integer(0),
    "nsid": integer(0),  # 0: the node set has the number of the body
    "pnode": integer(0),
    "iprt": integer(0),  # output only
    "drflag": integer(0),
    "rrflag": integer(0),
}
CONSTRAINED_NODAL_RIGID_BODY = Keyword(
    "CONSTRAINED_NODAL_RIGID_BODY",
    Card(BODY),
    options=("TITLE",),
    repeat=True,
    unique="pid",
    kind="part",
)
CONSTRAINED_NODAL_RIGID_BODY_INERTIA = Keyword(
    "CONSTRAINED_NODAL_RIGID_BODY_INERTIA",
    Card(BODY),
    Card(CENTRE),
    Card(TENSOR),
    Card(VELOCITY),
    Card(LOCAL, when=lambda entry: entry.ircs == 1),
    options=("TITLE",),
    repeat=True,
    unique="pid",
    kind="part",
)
