"""The nodes that a wall keeps before it.

Nodes of rigid bodies are not among them, as LS-DYNA's treatment by momentum leaves them out: RWPNAL = 0 on
*CONTROL_CONTACT. By penalty it could track them (RWPNAL > 0), or all nodes (RWPNAL < 0), which is not supported.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.explicit.rigid.members import members
from vmharness.explicit.walls.planar.face import NORMAL
from vmharness.mesh.sets import node_set

Index = NDArray[np.intp]
Flags = NDArray[np.bool_]


def tracked(deck: Deck, model: Model, entry: Entry, face: Array, ruled: Flags, rigid: Flags) -> Index:
    """Rows of the nodes of NSID (0: all) without NSIDEX, within OFFSET, that are free to move along the normal.

    `ruled` (n, 3): which displacements have a master already; `rigid` (n,): which nodes belong to rigid bodies.
    """
    nodes = node_set(deck, model, entry, "nsid") if entry.nsid else np.arange(model.node_count)
    if entry.nsidex:
        nodes = np.setdiff1d(nodes, node_set(deck, model, entry, "nsidex"))
    if entry.offset > 0.0:
        nodes = nodes[(model.x0[nodes] - face[0]) @ face[NORMAL] <= entry.offset]
    if rigid[nodes].any():
        _check_penalty(deck)
        model.facts["Rigid walls and rigid bodies"] = "the walls leave nodes of bodies alone: RWPNAL = 0"
        nodes = nodes[~rigid[nodes]]
    normal = np.abs(face[NORMAL]) > 1e-12
    held = ruled[nodes][:, normal]
    for row in nodes[held.any(axis=1) & ~held.all(axis=1)]:
        raise entry.error(
            "xh", f"node {model.ids[row]} is ruled along an axis oblique to the wall; not supported"
        )
    free = nodes[~held.any(axis=1)]
    if not free.size:
        raise entry.error("nsid", "no node that could meet the wall is free to move along its normal")
    return free


def rigid_nodes(deck: Deck, model: Model) -> Flags:
    """Which nodes (n,) belong to rigid bodies."""
    rigid = np.zeros(model.ids.size, bool)
    for member in members(deck, model):
        rigid[member.nodes] = True
    return rigid


def _check_penalty(deck: Deck) -> None:
    control = deck.first(CONTROL_CONTACT)
    if control and control.rwpnal > 0.0:
        what = "the penalty of rigid bodies at rigid walls is not supported; 0 leaves their nodes out"
        raise control.error("rwpnal", what)
