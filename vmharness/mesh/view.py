"""The view of a deck: what the figure of its model shows, whichever solver runs it."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, DeckError
from vmharness.deck.keywords.constrained.joint import (
    CONSTRAINED_JOINT_REVOLUTE,
    CONSTRAINED_JOINT_SPHERICAL,
)
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.mesh.bodies import Body, bodies, rigid_parts
from vmharness.mesh.discrete import Discrete, discrete
from vmharness.mesh.elements import elements, shells
from vmharness.mesh.loads import Arrows, arrows, gravity
from vmharness.mesh.nodes import Array, Index, Nodes, nodes_of
from vmharness.mesh.supports import supported
from vmharness.mesh.surface import CONTACTS, SINGLE, TWO_WAY, all_faces, segments, surface_nodes
from vmharness.mesh.velocities import velocities
from vmharness.mesh.walls import Wall, walls

BEAMS = (ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION)


@dataclass(frozen=True)
class Joint:
    """A joint of two rigid bodies, at the row of a node."""

    name: str
    node: int
    axis: Array | None  # (3,) of a revolute joint


@dataclass(frozen=True)
class View:
    """The model as read from the deck, to be drawn; rows are of `x`."""

    ids: NDArray[np.int64]  # (n,)
    x: Array  # (n, 3)
    shells: Index  # (ne, 4) deformable, as the solids and beams
    solids: Index  # (ne, 8)
    beams: Index  # (ne, 2) beams and trusses
    discrete: Discrete
    masses: Index  # rows with an *ELEMENT_MASS
    supports: Index  # rows with a fixed degree of freedom
    gravity: Array  # (3,) acceleration that body loads give at t = 0
    contacts: tuple[tuple[Index, Index], ...]  # tracked rows (nt,), segments (ns, 4)
    arrows: Mapping[str, Arrows] = field(default_factory=dict)  # by what acts: places, directions
    bodies: tuple[Body, ...] = ()
    joints: tuple[Joint, ...] = ()
    walls: tuple[Wall, ...] = ()
    orienting: frozenset[int] = frozenset()  # rows of nodes that only turn cross-sections

    @property
    def rows(self) -> Index:
        """The rows of the nodes that are part of the model."""
        return np.array([row for row in range(self.ids.size) if row not in self.orienting], np.intp)


def view_of(deck: Deck) -> View:
    """The view of a deck; raises DeckError if it refers to something that it does not define."""
    nodes = nodes_of(deck)
    masses = [nodes.find(table, "nid", table.nid) for table in deck.all(ELEMENT_MASS)]
    springs = discrete(deck, nodes)
    every = (
        shells(deck, nodes),
        elements(deck, nodes, 8, ELEMENT_SOLID),
        elements(deck, nodes, 2, *BEAMS),
    )
    rigid, found = rigid_parts(deck), tuple(bodies(deck, nodes, *every))
    shell, solid, beam = (each.only(np.isin(each.pid, list(rigid), invert=True)).nodes for each in every)
    fixed = [body.nodes for body in found if body.fixed]
    used = (*(each.nodes for each in every), springs.nodes, *masses, *(body.nodes for body in found))
    return View(
        ids=nodes.ids,
        x=nodes.x0,
        shells=shell,
        solids=solid,
        beams=beam,
        discrete=springs,
        masses=np.concatenate([np.zeros(0, np.intp), *masses]),
        supports=np.unique(np.concatenate([np.flatnonzero(supported(deck, nodes).any(axis=1)), *fixed])),
        gravity=gravity(deck),
        contacts=tuple(_contacts(deck, nodes)),
        arrows={**arrows(deck, nodes), **velocities(deck, nodes, found)},
        bodies=found,
        joints=tuple(_joints(deck, nodes)),
        walls=tuple(walls(deck, nodes)),
        orienting=frozenset(_orienting(deck, nodes).difference(*(each.ravel().tolist() for each in used))),
    )


def drawable(deck: Deck) -> View | None:
    """The view of the deck; None if the deck refers to something that it does not define."""
    try:
        return view_of(deck)
    except DeckError:
        return None


def _orienting(deck: Deck, nodes: Nodes) -> set[int]:
    """Rows of the third nodes of beams, which turn the cross-section."""
    return {
        int(row)
        for table in deck.all(*BEAMS)
        for row in nodes.find(table, "n3", table.n3, ground=True)
        if row >= 0
    }


def _joints(deck: Deck, nodes: Nodes) -> Iterator[Joint]:
    """The joints, each at its first node and with its number in the order of the deck."""
    kinds = {CONSTRAINED_JOINT_SPHERICAL: "spherical", CONSTRAINED_JOINT_REVOLUTE: "revolute"}
    entries = [entry for entry in deck.entries if entry.keyword in kinds]
    for number, entry in enumerate(entries, 1):
        row, axis = nodes.row(entry, "n1", entry.n1), None
        if entry.keyword is CONSTRAINED_JOINT_REVOLUTE:
            axis = nodes.x0[nodes.row(entry, "n3", entry.n3)] - nodes.x0[row]
        yield Joint(f"{kinds[entry.keyword]} joint {number}", row, axis)


def _contacts(deck: Deck, nodes: Nodes) -> Iterator[tuple[Index, Index]]:
    """Tracked nodes and segments of each contact; of a two-way contact those of both sides."""
    every = all_faces(deck, nodes)
    for contact in deck.all(*CONTACTS):
        opposite = "a" if contact.keyword is SINGLE else "b"
        tracked = [surface_nodes(deck, nodes, every, contact, "a")]
        faces = [segments(deck, nodes, every, contact, opposite)]
        if contact.keyword in TWO_WAY:
            tracked.append(np.unique(faces[0]))
            faces.append(segments(deck, nodes, every, contact, "a"))
        yield np.concatenate(tracked), np.concatenate(faces)
