"""*INITIAL_VELOCITY_RIGID_BODY: velocity of the centre and angular velocity of a rigid body at t = 0."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

INITIAL_VELOCITY_RIGID_BODY = Keyword(
    "INITIAL_VELOCITY_RIGID_BODY",
    Card(
        pid=integer(above=0),
        vx=real(0.0),
        vy=real(0.0),
        vz=real(0.0),
        vxr=real(0.0),
        vyr=real(0.0),
        vzr=real(0.0),
        icid=integer(0),
    ),
    repeat=True,
    unique="pid",
    kind="initial velocity of a rigid body",
)
