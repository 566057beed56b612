"""*BOUNDARY_PRESCRIBED_MOTION: velocity, acceleration or displacement by a curve over time."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, only, real
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords._dof import DOF

MOTION: dict[str, Field] = {
    "dof": DOF,
    "vad": integer(0, choices=(0, 1, 2)),
    "lcid": integer(above=0),
    "sf": real(1.0, zero_is_default=True),
    "vid": only(0),
    "death": real(1e28, zero_is_default=True, above=0.0),
    "birth": real(0.0, at_least=0.0),
}

BOUNDARY_PRESCRIBED_MOTION_NODE = Keyword(
    "BOUNDARY_PRESCRIBED_MOTION_NODE",
    Card({"nid": integer(above=0), **MOTION}),
    options=("ID",),
    repeat=True,
)

BOUNDARY_PRESCRIBED_MOTION_SET = Keyword(
    "BOUNDARY_PRESCRIBED_MOTION_SET",
    Card({"nsid": integer(above=0), **MOTION}),
    options=("ID",),
    repeat=True,
)
