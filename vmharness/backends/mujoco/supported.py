"""What MuJoCo represents of the keywords: SUPPORTS of the modules that translate, and what cannot change results."""

from functools import cache

from vmharness.backends.mujoco import (
    contacts,
    damping,
    joints,
    loads,
    masses,
    rigid,
    shells,
    springs,
    trusses,
    velocities,
)
from vmharness.backends.translation import declared
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.rule import only
from vmharness.deck.support import Supported, supports

MODULES = (springs, trusses, shells, masses, velocities, rigid, damping, joints, loads, contacts)


@cache
def supported() -> Supported:
    """By the names of the keywords."""
    return declared(MODULES, supports(CONTROL_TIMESTEP, dt2ms=only(0.0)))
