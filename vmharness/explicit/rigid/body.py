"""Each rigid body of a deck with its nodes, its mass and its inertia."""

from dataclasses import dataclass

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.extra_nodes import (
    CONSTRAINED_EXTRA_NODES_NODE,
    CONSTRAINED_EXTRA_NODES_SET,
)
from vmharness.deck.keywords.constrained.rigid_bodies import CONSTRAINED_RIGID_BODIES
from vmharness.deck.keywords.part import PART, has_inertia
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.rigid_bodies import (
    body_number,
    body_numbers,
    definitions,
    gives_inertia,
    held_by_cmo,
    lead_bodies,
    lead_number,
)
from vmharness.explicit.rigid.inertia import Inertia, inertia_of_card, inertia_of_points, lever_arms
from vmharness.explicit.state import Flags, Index
from vmharness.mesh.sets import node_set, nodes_of_parts

ON_AXIS = 1e-3  # of the distance of the farthest node: a nearer node is on the axis, as cards have few digits


@dataclass
class RigidBody:
    """A rigid body of the deck."""

    number: int
    entry: Entry  # its definition
    nodes: Index  # rows (m,), each once, in increasing order
    inertia_given: bool  # by `entry`, with mass and velocity
    held: Flags  # (6,) by CMO: translations of the centre, rotations


def find_bodies(deck: Deck, model: Model) -> list[RigidBody]:
    """Every rigid body with its nodes, in the order of `body_numbers`; raises DeckError for a node of two bodies."""
    _check_inertia_cards(deck)
    _check_merges(deck)
    lead = lead_bodies(deck)
    nodes: dict[int, list[Index]] = {number: [] for number in body_numbers(deck)}
    for entry in definitions(deck):
        nodes[lead.get(entry.pid, entry.pid)].append(_own_nodes(deck, model, entry))
    for keyword in (CONSTRAINED_EXTRA_NODES_NODE, CONSTRAINED_EXTRA_NODES_SET):
        for entry in deck.all(keyword):
            nodes[lead_number(deck, entry, "pid")].append(_extra_nodes(deck, model, entry))
    found = []
    for entry in definitions(deck):
        if entry.pid in nodes:
            rows = np.unique(np.concatenate(nodes[entry.pid]))
            found.append(RigidBody(entry.pid, entry, rows, gives_inertia(entry), held_by_cmo(deck, entry)))
    _check_no_common_node(model, found)
    return found


def body_inertia(model: Model, body: RigidBody) -> Inertia:
    """Mass, centre and inertia of a body; raises DeckError where it has no mass."""
    s, nodes, entry = model.state, body.nodes, body.entry
    if body.inertia_given:
        at = np.array([entry.xc, entry.yc, entry.zc])
        centre = model.x0[model.row(entry, "nodeid", entry.nodeid)] if entry.nodeid else at
        given = inertia_of_card(entry, centre)
        _check_lever_arms(model, body, given)
        return given
    if not s.mass[nodes].any():
        raise entry.error("pid", "a rigid body without mass: its nodes have none")
    return inertia_of_points(model.x0[nodes], s.mass[nodes], s.inertia[nodes])


def _own_nodes(deck: Deck, model: Model, entry: Entry) -> Index:
    if entry.keyword is PART:
        return nodes_of_parts(deck, model, {entry.pid})
    return node_set(deck, model, entry, "nsid" if entry.nsid else "pid")


def _extra_nodes(deck: Deck, model: Model, entry: Entry) -> Index:
    if entry.keyword is CONSTRAINED_EXTRA_NODES_SET:
        return node_set(deck, model, entry, "nsid")
    return np.array([model.row(entry, "nid", entry.nid)], np.intp)


def _check_inertia_cards(deck: Deck) -> None:
    """Only a rigid part can have the cards of *PART_INERTIA."""
    rigid = definitions(deck)
    for part in deck.all(PART):
        if has_inertia(part) and part not in rigid:
            raise part.error("mid", "*PART_INERTIA is for parts of *MAT_RIGID")


def _check_merges(deck: Deck) -> None:
    """A lead body is not itself merged into another, and mass and inertia of merged bodies are sums over nodes."""
    lead = lead_bodies(deck)
    given = {entry.pid for entry in definitions(deck) if gives_inertia(entry)}
    for entry in deck.all(CONSTRAINED_RIGID_BODIES):
        for field in ("pidl", "pidc"):
            if body_number(deck, entry, field) in given:
                raise entry.error(field, "not supported for a body of given inertia; give that of the whole")
        if entry.pidl in lead:
            raise entry.error("pidl", f"joins body {lead[entry.pidl]} itself; name that as PIDL")


def _check_no_common_node(model: Model, bodies: list[RigidBody]) -> None:
    """A node belongs to one body only."""
    owner = np.full(model.ids.size, -1)
    for place, body in enumerate(bodies):
        for row in body.nodes[owner[body.nodes] >= 0]:
            other = bodies[owner[row]].number
            what = f"node {model.ids[row]} belongs to rigid body {other} as well; merge them: *CONSTRAINED_RIGID_BODIES"
            raise body.entry.error("pid", what)
        owner[body.nodes] = place


def _check_lever_arms(model: Model, body: RigidBody, inertia: Inertia) -> None:
    """About an axis without inertia no node has a lever arm: a force there would give an infinite acceleration."""
    x = model.x0[body.nodes]
    arms, farthest = lever_arms(inertia, x), np.abs(x - inertia.centre).max(initial=0.0)
    for row in body.nodes[arms > ON_AXIS * farthest]:
        what = f"a principal moment is zero, but node {model.ids[row]} is off that axis, and forces there have a moment"
        raise body.entry.error("ixx", what)
