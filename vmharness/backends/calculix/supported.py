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
from vmharness.deck import support
from vmharness.deck.keywords import database
from vmharness.deck.keywords.boundary.spc import BOUNDARY_SPC_NODE, BOUNDARY_SPC_SET
from vmharness.deck.keywords.comment import COMMENT
from vmharness.deck.keywords.control.energy import CONTROL_ENERGY
from vmharness.deck.keywords.control.output import CONTROL_OUTPUT
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.define.curve import DEFINE_CURVE
from vmharness.deck.keywords.node import NODE
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.set.node import SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.keywords.title import TITLE
from vmharness.deck.rule import only
from vmharness.deck.support import Supported, supports, without_effect

OUTPUT = (*database.KEYWORDS, COMMENT, CONTROL_ENERGY, CONTROL_OUTPUT, TITLE)
SETS = (SET_SEGMENT, SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE)
SPC = {"cid": only(0)}


@cache
def supported() -> Supported:
    """By the names of the keywords."""
    own = [
        *(without_effect(keyword, "asks for output; no effect on results.") for keyword in OUTPUT),
        *(supports(keyword) for keyword in (NODE, PART, DEFINE_CURVE, *SETS)),
        *(supports(keyword, **SPC) for keyword in (BOUNDARY_SPC_NODE, BOUNDARY_SPC_SET)),
        supports(CONTROL_TERMINATION, endcyc=only(0), endeng=only(0.0)),
        supports(CONTROL_TIMESTEP, dt2ms=only(0.0), lctm=only(0)),
    ]
    modules = (springs, materials, beams, shells, solids, masses, motions, loads, velocities)
    return support.by_name([*own, *(each for module in modules for each in module.SUPPORTS)])
