"""The rigid bodies of a deck, by number, and the nodes that belong to each."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.extra_nodes import (
    CONSTRAINED_EXTRA_NODES_NODE,
    CONSTRAINED_EXTRA_NODES_SET,
)
from vmharness.deck.keywords.constrained.nodal_rigid_body import CONSTRAINED_NODAL_RIGID_BODY_INERTIA
from vmharness.deck.keywords.constrained.rigid_bodies import CONSTRAINED_RIGID_BODIES
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART, has_inertia
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.inertia import Inertia, of_card, of_points, off_axis
from vmharness.explicit.rigid.numbers import body_number, definitions, lead_number, leads, numbers
from vmharness.mesh.dof import coded
from vmharness.mesh.sets import node_set, nodes_of_parts

Index = NDArray[np.intp]

ROUND_OFF = 1e-3  # of the farthest node: on the axis of a tensor that has the digits of a card


@dataclass
class Member:
    """A rigid body of the deck."""

    number: int
    entry: Entry  # that defines it
    nodes: Index  # rows (m,), each once, in increasing order
    has_inertia: bool  # whether `entry` gives mass, inertia and velocity
    held: NDArray[np.bool_]  # (6,) by CMO: directions of the centre, rotations


def members(deck: Deck, model: Model) -> list[Member]:
    """Every rigid body with its nodes, in the order of `numbers`; raises DeckError for a node of two bodies."""
    _check_given(deck)
    _check_merges(deck)
    lead = leads(deck)
    nodes: dict[int, list[Index]] = {number: [] for number in numbers(deck)}
    for entry in definitions(deck):
        nodes[lead.get(entry.pid, entry.pid)].append(_own_nodes(deck, model, entry))
    for keyword in (CONSTRAINED_EXTRA_NODES_NODE, CONSTRAINED_EXTRA_NODES_SET):
        for entry in deck.all(keyword):
            nodes[lead_number(deck, entry, "pid")].append(_extra_nodes(deck, model, entry))
    found = []
    for entry in definitions(deck):
        if entry.pid in nodes:
            rows = np.unique(np.concatenate(nodes[entry.pid]))
            found.append(Member(entry.pid, entry, rows, _gives(entry), held_by_cmo(deck, entry)))
    _check_apart(model, found)
    return found


def _check_given(deck: Deck) -> None:
    """Only a rigid part can have an inertia of its own."""
    rigid = definitions(deck)
    for part in deck.all(PART):
        if has_inertia(part) and part not in rigid:
            raise part.error("mid", "*PART_INERTIA is for parts of *MAT_RIGID")


def _check_merges(deck: Deck) -> None:
    """A body that leads others does not join one, and mass and inertia are sums."""
    lead = leads(deck)
    given = {entry.pid for entry in definitions(deck) if _gives(entry)}
    for entry in deck.all(CONSTRAINED_RIGID_BODIES):
        for field in ("pidl", "pidc"):
            if body_number(deck, entry, field) in given:
                raise entry.error(field, "not supported for a body of given inertia; give that of the whole")
        if entry.pidl in lead:
            raise entry.error("pidl", f"joins body {lead[entry.pidl]} itself; name that as PIDL")


def _own_nodes(deck: Deck, model: Model, entry: Entry) -> Index:
    if entry.keyword is PART:
        return nodes_of_parts(deck, model, {entry.pid})
    return node_set(deck, model, entry, "nsid" if entry.nsid else "pid")


def _extra_nodes(deck: Deck, model: Model, entry: Entry) -> Index:
    if entry.keyword is CONSTRAINED_EXTRA_NODES_SET:
        return node_set(deck, model, entry, "nsid")
    return np.array([model.row(entry, "nid", entry.nid)], np.intp)


def _gives(entry: Entry) -> bool:
    return entry.keyword is CONSTRAINED_NODAL_RIGID_BODY_INERTIA or has_inertia(entry)


def held_by_cmo(deck: Deck, entry: Entry) -> NDArray[np.bool_]:
    """What CMO of the material holds (6,): directions of the centre, rotations."""
    held = np.zeros(6, bool)
    if entry.keyword is PART:
        material = deck.find(MAT_RIGID, mid=entry.mid)
        if material.cmo == 1:
            for offset, code in ((0, material.con1), (3, material.con2)):
                held[[offset + axis for axis in coded(code)]] = True
    return held


def _check_apart(model: Model, found: list[Member]) -> None:
    """A node moves with one body only."""
    owner = np.full(model.ids.size, -1)
    for place, member in enumerate(found):
        for row in member.nodes[owner[member.nodes] >= 0]:
            other = found[owner[row]].number
            what = f"node {model.ids[row]} belongs to rigid body {other} as well; merge them: *CONSTRAINED_RIGID_BODIES"
            raise member.entry.error("pid", what)
        owner[member.nodes] = place


def _check_lever(model: Model, member: Member, inertia: Inertia) -> None:
    """A rod has no inertia about its axis, and a point none at all: no node may pull it round there."""
    x = model.x0[member.nodes]
    far, reach = off_axis(inertia, x), np.abs(x - inertia.centre).max(initial=0.0)
    for row in member.nodes[far > ROUND_OFF * reach]:
        what = f"a principal moment is zero, but node {model.ids[row]} is off that axis, and forces there have a moment"
        raise member.entry.error("ixx", what)


def inertia_of(model: Model, member: Member) -> Inertia:
    """Mass, centre and inertia of a body; raises DeckError where it has no mass."""
    s, nodes, entry = model.state, member.nodes, member.entry
    if member.has_inertia:
        at = np.array([entry.xc, entry.yc, entry.zc])
        given = of_card(entry, model.x0[model.row(entry, "nodeid", entry.nodeid)] if entry.nodeid else at)
        _check_lever(model, member, given)
        return given
    if not s.mass[nodes].any():
        raise entry.error("pid", "a rigid body without mass: its nodes have none")
    return of_points(model.x0[nodes], s.mass[nodes], s.inertia[nodes])
