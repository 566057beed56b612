"""*LOAD_NODE: a force or moment on nodes, by a curve over time."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords._dof import DOF

LOAD: dict[str, Field] = {
    "dof": DOF,
    "lcid": integer(),
    "sf": real(1.0, zero_is_default=True),
    "cid": integer(0),
    "m1": integer(0),
    "m2": integer(0),
    "m3": integer(0),
}

LOAD_NODE_POINT = Keyword("LOAD_NODE_POINT", Card({"nid": integer(above=0), **LOAD}), repeat=True)

LOAD_NODE_SET = Keyword("LOAD_NODE_SET", Card({"nsid": integer(above=0), **LOAD}), repeat=True)
