"""*SECTION_DISCRETE: whether springs and dampers act along their axis or about it, clearance, failure.

KD and V0 would scale a spring's force by 1 + KD |rate|/V0: a damping in proportion to the force, for which no bound of
the stable step is known beforehand. CDL and TDL would join the motion of the nodes at a limit of the deflection.
"""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

SECTION_DISCRETE = Keyword(
    "SECTION_DISCRETE",
    Card(
        secid=integer(above=0),
        dro=integer(0, choices=(0, 1)),
        kd=only(0.0),
        v0=only(0.0),
        cl=real(0.0, at_least=0.0),
        fd=real(0.0),
    ),
    Card(cdl=only(0.0), tdl=only(0.0)),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
