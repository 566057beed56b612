"""*BOUNDARY_SPC: degrees of freedom that do not move."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

DOFS = ("dofx", "dofy", "dofz", "dofrx", "dofry", "dofrz")

FLAGS = {dof: integer(0) for dof in DOFS}

BOUNDARY_SPC_NODE = Keyword(
    "BOUNDARY_SPC_NODE",
    Card({"nid": integer(above=0), "cid": integer(0), **FLAGS}),
    options=("ID",),
    repeat=True,
)

BOUNDARY_SPC_SET = Keyword(
    "BOUNDARY_SPC_SET",
    Card({"nsid": integer(above=0), "cid": integer(0), **FLAGS}),
    options=("ID",),
    repeat=True,
)
