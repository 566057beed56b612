"""What CalculiX represents of the keywords: SUPPORTS of the modules that translate, and what cannot change results."""

from functools import cache

from vmharness.backends.calculix import (
    beams,
    loads,
    masses,
    materials,
    motions,
    shells,
    solids,
    springs,
    velocities,
)
from vmharness.backends.translation import declared
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.rule import only
from vmharness.deck.support import Supported, supports

MODULES = (springs, materials, beams, shells, solids, masses, motions, loads, velocities)


@cache
def supported() -> Supported:
    """By the names of the keywords."""
    return declared(MODULES, supports(SET_SEGMENT), supports(CONTROL_TIMESTEP, dt2ms=only(0.0), lctm=only(0)))
