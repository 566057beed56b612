"""Initial velocities of nodes."""

from vmharness.backends._translation.velocities import SUPPORTS, initial_velocities
from vmharness.backends.opensees.model import Model
from vmharness.deck import Deck

__all__ = ["SUPPORTS", "add"]


def add(deck: Deck, model: Model) -> None:
    """Note the velocity of every node."""
    for _, rows, velocity in initial_velocities(deck, model.nodes):
        model.velocities[rows] = velocity
