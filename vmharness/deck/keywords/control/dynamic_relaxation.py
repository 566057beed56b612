"""*CONTROL_DYNAMIC_RELAXATION: a state of rest before the run, if IDRFLG asks for one."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CONTROL_DYNAMIC_RELAXATION = Keyword(
    "CONTROL_DYNAMIC_RELAXATION",
    Card(
        nrcyck=integer(250),
        drtol=real(0.001),
        drfctr=real(0.995),
        drterm=real(0.0),
        tssfdr=real(0.0),
        irelal=integer(0),
        edttl=real(0.04),
        idrflg=integer(0),
    ),
    Card(optional=True, drpset=integer(0)),
    single=True,
)
