"""The view of a deck: what the figure of its model shows, whichever solver runs it."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.mesh.elements import by_part, elements, shells
from vmharness.mesh.loads import Arrows, arrows, gravity
from vmharness.mesh.nodes import Array, Index, Nodes, nodes_of
from vmharness.mesh.supports import supported
from vmharness.mesh.surface import CONTACTS, SINGLE, TWO_WAY, all_faces, segments, surface_nodes


@dataclass(frozen=True)
class View:
    """The model as read from the deck, to be drawn; rows are of `x`."""

    ids: NDArray[np.int64]  # (n,)
    x: Array  # (n, 3)
    shells: Index  # (ne, 4)
    solids: Index  # (ne, 8)
    beams: Index  # (ne, 2) beams and trusses
    discrete: Index  # (ne, 2) springs and dampers between nodes
    masses: Index  # rows with an *ELEMENT_MASS
    supports: Index  # rows with a fixed degree of freedom
    gravity: Array  # (3,) acceleration that body loads give at t = 0
    contacts: tuple[tuple[Index, Index], ...]  # tracked rows (nt,), segments (ns, 4)
    arrows: Mapping[str, Arrows] = field(default_factory=dict)  # by what acts: places, directions


def view_of(deck: Deck) -> View:
    """The view of a deck; raises DeckError if it refers to something that it does not define."""
    nodes = nodes_of(deck)
    masses = [nodes.find(table, "nid", table.nid) for table in deck.all(ELEMENT_MASS)]
    discrete = by_part(elements(deck, nodes, 2, ELEMENT_DISCRETE)).nodes
    return View(
        ids=nodes.ids,
        x=nodes.x0,
        shells=shells(deck, nodes).nodes,
        solids=elements(deck, nodes, 8, ELEMENT_SOLID).nodes,
        beams=elements(deck, nodes, 2, ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION).nodes,
        discrete=discrete[discrete[:, 1] >= 0],  # without those to the ground
        masses=np.concatenate([np.zeros(0, np.intp), *masses]),
        supports=np.flatnonzero(supported(deck, nodes).any(axis=1)),
        gravity=gravity(deck),
        contacts=tuple(_contacts(deck, nodes)),
        arrows=arrows(deck, nodes),
    )


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
