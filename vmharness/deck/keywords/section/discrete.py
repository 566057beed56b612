"""*SECTION_DISCRETE: whether springs and dampers act along their axis or about it, clearance, failure.

KD and V0 scale a spring's force by 1 + KD |rate|/V0: a damping in proportion to the force. CDL and TDL join the motion
of the nodes at a limit of the deflection.
"""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

SECTION_DISCRETE = Keyword(
    "SECTION_DISCRETE",
    Card(
        secid=integer(above=0),
        dro=integer(0),
        kd=real(0.0),
        v0=real(0.0),
        cl=real(0.0),
        fd=real(0.0),
    ),
    Card(cdl=real(0.0), tdl=real(0.0)),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
