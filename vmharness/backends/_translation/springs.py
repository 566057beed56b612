"""*ELEMENT_DISCRETE between two nodes, along the line that joins them, and the materials that all adapters know."""

from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.mat.damper_viscous import MAT_DAMPER_VISCOUS
from vmharness.deck.keywords.mat.spring_elastic import MAT_SPRING_ELASTIC
from vmharness.deck.keywords.section.discrete import SECTION_DISCRETE
from vmharness.deck.rule import above, no_effect, only
from vmharness.deck.support import supports

SUPPORTS = (
    supports(ELEMENT_DISCRETE, n2=above(0), vid=only(0), pf=no_effect("affects output only")),
    supports(
        SECTION_DISCRETE, dro=only(0), kd=only(0.0), cl=only(0.0), fd=only(0.0), cdl=only(0.0), tdl=only(0.0)
    ),
    supports(MAT_SPRING_ELASTIC),
    supports(MAT_DAMPER_VISCOUS),
)
