"""Degrees of freedom whose motion the deck gives for the whole run: held by a support, or prescribed by a curve."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.boundary.prescribed_motion import (
    BOUNDARY_PRESCRIBED_MOTION_NODE,
    BOUNDARY_PRESCRIBED_MOTION_SET,
)
from vmharness.deck.keywords.boundary.prescribed_motion_rigid import BOUNDARY_PRESCRIBED_MOTION_RIGID
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART, PART_CONTACT
from vmharness.mesh.dof import CODES, coded, place
from vmharness.mesh.nodes import Nodes
from vmharness.mesh.sets import node_set, nodes_of_parts
from vmharness.mesh.supports import supported

PLACES = (1, 2, 3, 5, 6, 7)  # values of DOF that are one degree of freedom
GLOBAL = 1  # CMO of *MAT_RIGID: constraints along global axes


def driven(deck: Deck, nodes: Nodes) -> NDArray[np.bool_]:
    """Which degrees of freedom (n, 6), translations and rotations, of the nodes the deck gives.

    Of a node of a rigid body the translations are given only if the rotations of the body are given, too.
    """
    given = supported(deck, nodes)
    for entry in _throughout(deck, BOUNDARY_PRESCRIBED_MOTION_NODE.name):
        given[nodes.row(entry, "nid", entry.nid), place(entry)] = True
    for entry in _throughout(deck, BOUNDARY_PRESCRIBED_MOTION_SET.name):
        given[node_set(deck, nodes, entry, "nsid"), place(entry)] = True
    for pid, of_body in driven_bodies(deck).items():
        if of_body[3:].all():
            given[nodes_of_parts(deck, nodes, {pid})] |= of_body
    return given


def driven_bodies(deck: Deck) -> dict[int, NDArray[np.bool_]]:
    """Which degrees of freedom (6,) of each rigid part, by its number, the deck gives."""
    constraints = {entry.mid: _held(entry) for entry in deck.all(MAT_RIGID) if entry.cmo == GLOBAL}
    free = np.zeros(6, bool)
    bodies = {entry.pid: constraints.get(entry.mid, free).copy() for entry in deck.all(PART, PART_CONTACT)}
    for entry in _throughout(deck, BOUNDARY_PRESCRIBED_MOTION_RIGID.name):
        bodies.setdefault(entry.pid, free.copy())[place(entry)] = True
    return bodies


def _held(entry: Entry) -> NDArray[np.bool_]:
    """Degrees of freedom (6,) that CON1 and CON2 hold."""
    held = np.zeros(6, bool)
    for offset, code in ((0, entry.con1), (3, entry.con2)):
        if 0 <= code < len(CODES):
            held[[offset + axis for axis in coded(code)]] = True
    return held


def _throughout(deck: Deck, keyword: str) -> list[Entry]:
    """The motions of one degree of freedom that the deck prescribes from the start to the end of the run."""
    end = max((control.endtim for control in deck.all(CONTROL_TERMINATION)), default=0.0)
    return [
        entry
        for entry in deck.all(keyword)
        if entry.dof in PLACES and entry.birth <= 0.0 and entry.death >= end
    ]
