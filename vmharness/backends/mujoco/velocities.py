"""Initial velocities of nodes."""

from vmharness.backends._translation.velocities import SUPPORTS, initial_velocities
from vmharness.backends.mujoco.model import Model
from vmharness.deck import Deck

__all__ = ["SUPPORTS", "add"]


def add(deck: Deck, model: Model) -> None:
    """Note the velocity of every node that is free to move."""
    for _, rows, velocity in initial_velocities(deck, model.nodes):
        model.v[rows] = velocity
    model.v[model.held] = 0.0
