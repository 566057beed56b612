"""*LOAD_RIGID_BODY: a force or moment on a rigid body, by a curve over time."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords.load.node import LOAD

LOAD_RIGID_BODY = Keyword("LOAD_RIGID_BODY", Card({"pid": integer(above=0), **LOAD}), repeat=True)
