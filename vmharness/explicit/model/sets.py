"""Parts of the deck as rows of the state's arrays, the centres of rigid bodies among them."""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Index
from vmharness.explicit.rigid.definitions import body_numbers
from vmharness.mesh.sets import nodes_of_parts


def masses_of_parts(deck: Deck, model: Model, pids: set[int]) -> Index:
    """Rows (m,) of all nodes of these parts, and of the centres of the rigid bodies among them."""
    centres = [model.centre(number) for number in body_numbers(deck) if number in pids]
    return np.concatenate([nodes_of_parts(deck, model, pids), np.array(centres, np.intp)])
