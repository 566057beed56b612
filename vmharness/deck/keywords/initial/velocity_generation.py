"""*INITIAL_VELOCITY_GENERATION: a rigid motion as initial velocities."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

INITIAL_VELOCITY_GENERATION = Keyword(
    "INITIAL_VELOCITY_GENERATION",
    Card(
        id=integer(),
        styp=integer(1),
        omega=real(0.0),
        vx=real(0.0),
        vy=real(0.0),
        vz=real(0.0),
        ivatn=integer(0),
        icid=integer(0),
    ),
    Card(
        xc=real(0.0),
        yc=real(0.0),
        zc=real(0.0),
        nx=real(0.0),
        ny=real(0.0),
        nz=real(0.0),
        phase=integer(0),
        irigid=integer(0),
    ),
    repeat=True,
)
