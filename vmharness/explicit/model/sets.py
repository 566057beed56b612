"""Parts of the deck as rows of the state's arrays, the centres of rigid bodies among them."""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.set.node import (
    SET_NODE_ADD,
    SET_NODE_COLUMN,
    SET_NODE_GENERAL,
    SET_NODE_LIST,
    SET_NODE_LIST_GENERATE,
)
from vmharness.deck.keywords.set.segment import SET_SEGMENT
from vmharness.deck.keywords.set.shell import SET_SHELL_LIST, SET_SHELL_LIST_GENERATE
from vmharness.deck.rule import among, anything, no_effect, only, where
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.rigid_bodies import body_numbers
from vmharness.explicit.state import Index
from vmharness.mesh.sets import PART_SETS, nodes_of_parts

MECHANICS = {"solver": only("MECH")}
ATTRIBUTES = {f"da{i}": no_effect("nothing here uses attributes of sets") for i in range(1, 5)}
OF_NODES = {f"a{i}": no_effect("nothing here uses attributes of nodes") for i in range(1, 5)}
OF_ALL = {
    f"e{k}": anything(where(lambda entry: all(entry.option == "ALL"), "ALL is all nodes"))
    for k in range(1, 8)
}
SCALES = {"its": no_effect("is of analyses that couple two scales")}

SUPPORTS = (
    supports(SET_NODE_LIST, **MECHANICS, **ATTRIBUTES, **SCALES),
    supports(SET_NODE_LIST_GENERATE, **MECHANICS, **ATTRIBUTES, **SCALES),
    supports(SET_NODE_ADD, **MECHANICS, **ATTRIBUTES, **SCALES),
    supports(SET_NODE_COLUMN, **MECHANICS, **ATTRIBUTES, **SCALES, **OF_NODES),
    supports(
        SET_NODE_GENERAL, **MECHANICS, **ATTRIBUTES, **SCALES, option=among("ALL", "NODE", "PART"), **OF_ALL
    ),
    *(supports(keyword, **MECHANICS, **ATTRIBUTES) for keyword in PART_SETS),
    supports(SET_SHELL_LIST, **ATTRIBUTES),
    supports(SET_SHELL_LIST_GENERATE, **ATTRIBUTES),
    supports(SET_SEGMENT, **MECHANICS, **ATTRIBUTES, **SCALES, **{f"a{i}": only(0.0) for i in range(1, 5)}),
)


def masses_of_parts(deck: Deck, model: Model, pids: set[int]) -> Index:
    """Rows (m,) of all nodes of these parts, and of the centres of the rigid bodies among them."""
    centres = [model.centre(number) for number in body_numbers(deck) if number in pids]
    return np.concatenate([nodes_of_parts(deck, model, pids), np.array(centres, np.intp)])
