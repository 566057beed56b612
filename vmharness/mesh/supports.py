"""Supports of a deck: degrees of freedom that *BOUNDARY_SPC and the constraint codes of *NODE hold."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.boundary.spc import BOUNDARY_SPC_NODE, BOUNDARY_SPC_SET, DOFS
from vmharness.deck.keywords.node import NODE
from vmharness.mesh.dof import coded
from vmharness.mesh.nodes import Nodes
from vmharness.mesh.sets import node_set


def supported(deck: Deck, nodes: Nodes) -> NDArray[np.bool_]:
    """Which degrees of freedom (n, 6), translations and rotations, any support of the deck holds."""
    fixed = np.zeros((nodes.ids.size, 6), bool)
    for entry in deck.all(BOUNDARY_SPC_NODE):
        fixed[nodes.row(entry, "nid", entry.nid)] |= _flags(entry)
    for entry in deck.all(BOUNDARY_SPC_SET):
        fixed[node_set(deck, nodes, entry, "nsid")] |= _flags(entry)
    for entry in deck.all(NODE):
        _codes(entry, nodes, fixed)
    return fixed


def _flags(entry: Entry) -> NDArray[np.bool_]:
    return np.array([getattr(entry, dof) == 1 for dof in DOFS])


def _codes(entry: Entry, nodes: Nodes, fixed: NDArray[np.bool_]) -> None:
    for offset, codes in ((0, entry.tc), (3, entry.rc)):
        for i in np.flatnonzero(codes):
            row = nodes.row(entry, "nid", entry.nid[i])
            fixed[row, [offset + axis for axis in coded(codes[i])]] = True
