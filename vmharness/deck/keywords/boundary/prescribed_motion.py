"""*BOUNDARY_PRESCRIBED_MOTION: velocity, acceleration or displacement by a curve over time."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords._dof import DOF

MOTION: dict[str, Field] = {
    "dof": DOF,
    "vad": integer(0),
    "lcid": integer(),
    "sf": real(1.0, zero_is_default=True),
    "vid": integer(0),
    "death": real(1e28, zero_is_default=True),
    "birth": real(0.0),
}

OFFSETS = Card(
    offset1=real(0.0),
    offset2=real(0.0),
    lrb=integer(0),
    node1=integer(0),
    node2=integer(0),
    when=lambda entry: abs(entry.dof) in (9, 10, 11) or entry.vad == 4,
)

BOUNDARY_PRESCRIBED_MOTION_NODE = Keyword(
    "BOUNDARY_PRESCRIBED_MOTION_NODE",
    Card({"nid": integer(above=0), **MOTION}),
    OFFSETS,
    options=("ID",),
    repeat=True,
)

BOUNDARY_PRESCRIBED_MOTION_SET = Keyword(
    "BOUNDARY_PRESCRIBED_MOTION_SET",
    Card({"nsid": integer(above=0), **MOTION}),
    OFFSETS,
    options=("ID",),
    repeat=True,
)
