"""*ELEMENT_SHELL: shells of four nodes; a triangle repeats its third as N4, or leaves N4 out."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real
from vmharness.deck.keyword import Keyword

ID = integer(width=8, above=0)
MIDSIDE_NODES: dict[str, Field] = {f"n{i}": integer(0, width=8) for i in range(5, 9)}
CORNERS = ("n1", "n2", "n3", "n4")
NODES: dict[str, Field] = {**dict.fromkeys(CORNERS[:3], ID), "n4": integer(0, width=8)}
CONNECTIVITY = Card({"eid": ID, "pid": ID, **NODES, **MIDSIDE_NODES})

ELEMENT_SHELL = Keyword(
    "ELEMENT_SHELL", CONNECTIVITY, table=True, unique="eid", kind="shell element", corners=CORNERS
)

ELEMENT_SHELL_THICKNESS = Keyword(
    "ELEMENT_SHELL_THICKNESS",
    CONNECTIVITY,
    Card(
        thic1=real(0.0, width=16),
        thic2=real(0.0, width=16),
        thic3=real(0.0, width=16),
        thic4=real(0.0, width=16),
        beta=real(0.0, width=16),
    ),
    table=True,
    unique="eid",
    kind="shell element",
    corners=CORNERS,
)
