"""Parts of the deck as rows of the state's arrays, the centres of rigid bodies among them."""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.set.node import SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE
from vmharness.deck.keywords.set.part import SET_PART_LIST
from vmharness.deck.rule import among, only
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.rigid_bodies import body_numbers
from vmharness.explicit.state import Index
from vmharness.mesh.sets import nodes_of_parts

MECHANICS = {"solver": only("MECH")}

SUPPORTS = (
    supports(SET_NODE_LIST, **MECHANICS),
    supports(SET_NODE_LIST_GENERATE, **MECHANICS),
    supports(SET_NODE_GENERAL, **MECHANICS, option=among("ALL", "NODE", "PART")),
    supports(SET_PART_LIST, **MECHANICS),
)


def masses_of_parts(deck: Deck, model: Model, pids: set[int]) -> Index:
    """Rows (m,) of all nodes of these parts, and of the centres of the rigid bodies among them."""
    centres = [model.centre(number) for number in body_numbers(deck) if number in pids]
    return np.concatenate([nodes_of_parts(deck, model, pids), np.array(centres, np.intp)])
