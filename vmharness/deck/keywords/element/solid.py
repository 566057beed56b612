"""*ELEMENT_SOLID: hexahedra of eight nodes, in two lines or, as of old, in one; a wedge repeats its 5th and 6th node.

EID PID                              EID PID N1 N2 N3 N4 N5 N6 N7 N8
N1 N2 N3 N4 N5 N6 N7 N8 N9 N10
"""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer
from vmharness.deck.keyword import Keyword

ID = integer(width=8, above=0)
CORNERS = tuple(f"n{i}" for i in range(1, 9))
NODES: dict[str, Field] = dict.fromkeys(CORNERS, ID)

ELEMENT_SOLID = Keyword(
    "ELEMENT_SOLID",
    Card(eid=ID, pid=ID),
    Card(NODES, n9=integer(0, width=8), n10=integer(0, width=8)),  # of tetrahedra
    one_line=Card({"eid": ID, "pid": ID, **NODES}),
    table=True,
    unique="eid",
    kind="solid element",
    corners=CORNERS,
)
