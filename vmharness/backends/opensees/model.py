"""The model of OpenSees while it is translated: its commands, and what later commands must know of earlier ones."""

from dataclasses import dataclass, field
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck
from vmharness.mesh.nodes import Array, Nodes

Command = list[Any]  # the name of a function of OpenSees, and its arguments


@dataclass
class Model:
    """The commands for a deck, in the order in which OpenSees needs them; tags of nodes and elements are the deck's."""

    deck: Deck
    nodes: Nodes
    mass: Array  # (n,) of elements and lumped masses
    lumped: Array  # (n,) of lumped masses alone: elements bring theirs
    inertia: Array  # (n,) rotary, of beams and shells
    used: NDArray[np.bool_]  # (n,) nodes that an element or a mass joins
    stiff: Array  # (n,) bound of the row sums of |K| at the nodes
    materials: list[Command] = field(default_factory=list)
    elements: list[Command] = field(default_factory=list)
    loads: list[Command] = field(default_factory=list)
    implicit: bool = False  # where an element has no mass matrix that explicit steps could use
    velocities: Array = field(default_factory=lambda: np.zeros((0, 3)))
    tag: "count[int]" = field(default_factory=lambda: count(1))  # of materials, time series and patterns

    def next(self) -> int:
        """A tag that no other material, time series or pattern has."""
        return next(self.tag)

    def join(self, first: int, second: int, stiffness: float) -> None:
        """Note that an element of this stiffness joins two rows of nodes: each has K_ii = k and K_ij = -k of it."""
        self.used[[first, second]] = True
        self.stiff[[first, second]] += 2.0 * stiffness

    def length(self, first: int, second: int) -> float:
        """The distance of two rows of nodes at the beginning."""
        return float(np.linalg.norm(self.nodes.x0[second] - self.nodes.x0[first]))

    def id(self, row: int) -> int:
        """The number of the node of a row."""
        return int(self.nodes.ids[row])


def empty(deck: Deck, nodes: Nodes) -> Model:
    """A model without commands."""
    n = nodes.ids.size
    return Model(
        deck,
        nodes,
        np.zeros(n),
        np.zeros(n),
        np.zeros(n),
        np.zeros(n, bool),
        np.zeros(n),
        velocities=np.zeros((n, 3)),
    )
