"""*BOUNDARY_PRESCRIBED_MOTION_RIGID: the motion of a rigid body by a curve over time."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords.boundary.prescribed_motion import MOTION, OFFSETS

BOUNDARY_PRESCRIBED_MOTION_RIGID = Keyword(
    "BOUNDARY_PRESCRIBED_MOTION_RIGID",
    Card({"pid": integer(above=0), **MOTION}),
    OFFSETS,
    options=("ID",),
    repeat=True,
)
