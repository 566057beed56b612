"""*INITIAL_VELOCITY_GENERATION: a rigid motion as initial velocities."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

INITIAL_VELOCITY_GENERATION = Keyword(
    "INITIAL_VELOCITY_GENERATION",
    Card(
        id=integer(at_least=0),
        styp=integer(1, choices=(1, 2, 3)),
        omega=real(0.0),
        vx=real(0.0),
        vy=real(0.0),
        vz=real(0.0),
        ivatn=only(0),
        icid=only(0),
    ),
    Card(
        xc=real(0.0),
        yc=real(0.0),
        zc=real(0.0),
        nx=real(0.0),
        ny=real(0.0),
        nz=real(0.0),
        phase=only(0),
        irigid=only(0),
    ),
    repeat=True,
)
