"""The model of MuJoCo while it is translated: what later modules must know of earlier ones."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.mesh.nodes import Array, Index, Nodes
from vmharness.mesh.supports import supported


@dataclass
class Body:
    """A rigid body; `mass` is zero for one that is held in space."""

    number: int
    entry: Entry  # its *PART
    rows: Index  # of its nodes
    fixed: bool
    mass: float
    centre: Array  # (3,)
    tensor: Array  # (3, 3) about the centre
    v: Array  # (3,) velocity of the centre at t = 0
    omega: Array  # (3,)
    joint: "Joint | None" = None  # to its parent; without one it is free


@dataclass(frozen=True)
class Joint:
    """A spherical joint, or a revolute one about `axis`, of a body to `parent`: another body, or None for space."""

    parent: Body | None
    anchor: Array  # (3,)
    axis: Array | None


@dataclass(frozen=True)
class Tendon:
    """A spring and damper along the line between two nodes: f = k (l - rest) + c dl/dt, positive in tension."""

    eid: int
    ends: tuple[int, int]  # rows of nodes
    stiffness: float
    damping: float
    rest: float


@dataclass(frozen=True)
class Contact:
    """Masses that touch a plane: f = k |g| - c dg/dt, never in tension."""

    number: int
    rows: Index  # of the nodes
    origin: Array  # (3,) a point of the plane
    normal: Array  # (3,) out of it, toward the masses
    size: float  # of the surface
    stiffness: float
    damping: float  # c as a fraction of the critical 2 sqrt(k m)
    friction: float

    @property
    def spring(self) -> bool:
        """Whether it is a spring that acts beyond a gap and nothing else, which MuJoCo has without its contacts."""
        return not (self.damping or self.friction)


@dataclass(frozen=True)
class Load:
    """A force with the direction and size of `vector` times a curve, on a node."""

    row: int
    vector: Array  # (3,)
    t: Array
    value: Array


@dataclass
class Model:
    """What the deck has; rows are of its nodes."""

    deck: Deck
    nodes: Nodes
    mass: Array  # (n,)
    used: NDArray[np.bool_]  # (n,) nodes with an element or a mass
    held: NDArray[np.bool_]  # (n, 3) translations that a support holds
    v: Array  # (n, 3) at t = 0
    drag: Array  # (n,) D of mass-proportional damping, f = -D m v
    bodies: dict[int, Body] = field(default_factory=dict)  # by number
    owner: dict[int, Body] = field(default_factory=dict)  # by row of a node
    tendons: list[Tendon] = field(default_factory=list)
    contacts: list[Contact] = field(default_factory=list)
    gravity: Array = field(default_factory=lambda: np.zeros(3))  # constant part
    bases: list[Load] = field(default_factory=list)  # accelerations that vary; they act on all
    loads: list[Load] = field(default_factory=list)
    joints: list[tuple[int, float]] = field(default_factory=list)  # child, and the sign of its force
    steps: list[float] = field(default_factory=list)  # critical steps L/c of trusses and of held shells

    def id(self, row: int) -> int:
        """The number of the node of a row."""
        return int(self.nodes.ids[row])

    def length(self, first: int, second: int) -> float:
        """The distance of two rows of nodes at the beginning."""
        return float(np.linalg.norm(self.nodes.x0[second] - self.nodes.x0[first]))

    def free(self, row: int) -> list[int]:
        """The axes along which no support holds a row."""
        return [int(axis) for axis in np.flatnonzero(~self.held[row])]

    def moves(self, row: int) -> bool:
        """Whether a row is a mass that can move."""
        return row not in self.owner and bool(self.used[row]) and not bool(self.held[row].all())


def empty(deck: Deck, nodes: Nodes) -> Model:
    """A model with nodes and supports only."""
    n = nodes.ids.size
    held = supported(deck, nodes)[:, :3]
    return Model(deck, nodes, np.zeros(n), np.zeros(n, bool), held, np.zeros((n, 3)), np.zeros(n))
