"""Initial velocities of nodes, except those of elements that CalculiX expands to solids: they do not get them."""

import numpy as np

from vmharness.backends._translation.velocities import SUPPORTS, initial_velocities
from vmharness.backends.calculix.model import Lines, Model, real
from vmharness.deck import Deck

__all__ = ["SUPPORTS", "add", "lines"]


def add(deck: Deck, model: Model) -> None:
    """Note the velocity of every node; raises DeckError for nodes that would not get it."""
    for entry, rows, velocity in initial_velocities(deck, model.nodes):
        if velocity.any() and model.expanded[rows].any():
            what = "calculix: initial velocities do not reach the solids to which it expands trusses, beams and shells"
            raise entry.error(None, what)
        model.velocities[rows] = velocity


def lines(model: Model) -> Lines:
    """*INITIAL CONDITIONS of all nodes that move."""
    moving = np.argwhere((model.velocities != 0.0) & model.used[:, None]).tolist()
    values = [f"{row + 1},{axis + 1},{real(float(model.velocities[row, axis]))}" for row, axis in moving]
    return ["*INITIAL CONDITIONS,TYPE=VELOCITY", *values] if values else []
