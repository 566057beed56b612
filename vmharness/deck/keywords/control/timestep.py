"""*CONTROL_TIMESTEP: how large the time step may be."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, skip
from vmharness.deck.keyword import Keyword

CONTROL_TIMESTEP = Keyword(
    "CONTROL_TIMESTEP",
    Card(
        dtinit=real(0.0),
        tssfac=real(0.9, zero_is_default=True),
        isdo=integer(0),
        tslimt=real(0.0),
        dt2ms=real(0.0),
        lctm=integer(0),
        erode=integer(0),
        ms1st=integer(0),
    ),
    Card(
        optional=True,
        dt2msf=real(0.0),
        dt2mslc=integer(0),
        imscl=integer(0),
        _4=skip(),
        _5=skip(),
        rmscl=real(0.0),
        emscl=real(0.0),
        ihdo=integer(0),
    ),
    Card(optional=True, rmavg=real(0.0), igado=integer(0), dtusr=real(0.0), dtdynv=integer(0)),
    single=True,
)
