"""*ELEMENT_MASS: masses at nodes, and what a node needs to be one."""

import numpy as np

from vmharness.backends.mujoco.model import Model
from vmharness.deck import Deck, DeckError
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.support import supports

SUPPORTS = (supports(ELEMENT_MASS),)


def add(deck: Deck, model: Model) -> None:
    """Add the masses to their nodes."""
    for table in deck.all(ELEMENT_MASS):
        rows = model.nodes.find(table, "nid", table.nid)
        model.used[rows] = True
        np.add.at(model.mass, rows, table.mass)


def check(deck: Deck, model: Model) -> None:
    """Raise DeckError for a node that can move and has no mass: MuJoCo has no such body."""
    for row in np.flatnonzero(model.used).tolist():
        if model.moves(row) and not model.mass[row] > 0.0:
            what = f"mujoco: node {model.id(row)} can move and has no mass"
            raise DeckError(what, str(deck.path.name), 1)
