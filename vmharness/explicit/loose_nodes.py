"""Nodes that belong to nothing: no element joins them, nothing moves or loads them, and they have no mass.

LS-DYNA runs with such nodes; here they stay at rest. A node that is without mass, but loaded, moved or touched by a
contact, is an error unless all its directions are ruled: its acceleration would be infinite.
"""

import numpy as np

from vmharness.deck import Deck, DeckError, Finding
from vmharness.deck.keywords.node import NODE
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.loads.node import NodalLoad
from vmharness.explicit.loads.segment import Pressure
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Flags, Index
from vmharness.mesh.sets import nodes_of_parts


def rest_loose_nodes(deck: Deck, model: Model) -> None:
    """Put loose nodes at rest, and say so; raises DeckError for another free node without mass."""
    held = np.zeros((model.ids.size, 6), bool)
    for constraint in model.constraints:
        held |= constraint.fixed
    massless = (model.state.mass <= 0.0) & ~held[:, :3].all(axis=1)
    if not massless.any():
        return
    acted = _acted_on(deck, model)
    if (wrong := np.flatnonzero(massless & acted)).size:
        raise _error(deck, model, wrong, "a free node without mass", "; give it mass, or support it")
    rows = np.flatnonzero(massless)
    model.state.v[rows] = model.state.omega[rows] = 0.0
    finding = _error(deck, model, rows, "belongs to no element and has no mass", "; it stays at rest")
    model.idle.append(Finding(finding, idle=True))


def _acted_on(deck: Deck, model: Model) -> Flags:
    """Nodes (n,) of elements, loads, contacts and prescribed motions."""
    acted = np.zeros(model.ids.size, bool)
    acted[model.node_count :] = True  # centres of rigid bodies
    pids = {int(pid) for table in deck.entries if table.keyword.corners for pid in np.unique(table.pid)}
    acted[nodes_of_parts(deck, model, pids)] = True
    for item in (*model.forces, *model.constraints):
        match item:
            case NodalLoad() | PrescribedMotion():
                acted[item.nodes] = True
            case Pressure():
                acted[item.faces] = True
            case Contact():
                acted[item.tracked] = acted[item.segments] = True
    return acted


def _error(deck: Deck, model: Model, rows: Index, what: str, advice: str) -> DeckError:
    """What is wrong with, or to say of, the first of some nodes, at its line of *NODE."""
    nid = model.ids[rows[0]]
    others = f" ({rows.size} such nodes)" if rows.size > 1 else ""
    table = next(table for table in deck.all(NODE) if np.any(table.nid == nid))
    return table.error("nid", what + others + advice, int(np.flatnonzero(table.nid == nid)[0]))
