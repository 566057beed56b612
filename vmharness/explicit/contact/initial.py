"""Nodes that begin behind the surface: refused, moved to it, or kept.

IGNORE = 0    a contact that is not automatic is refused; an automatic one moves the nodes to the surface, before
              the run and without strain, but not those of a rigid part
IGNORE = 1,2  the node stays, and its gap counts from there
"""

import numpy as np

from vmharness.deck import Entry
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.tracked import Tracked
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Index


def treat(
    contact: Contact,
    passes: list[Tracked],
    model: Model,
    entry: Entry,
    kept: bool,
    automatic: bool,
    rigid: Index,
) -> None:
    """Do so with the nodes of a contact, and say it in the model's facts; `rigid`: rows of nodes of rigid parts."""
    found = contact.initial_penetrations(model.state.x)
    if not found:
        return
    depths = [float(np.linalg.norm(way)) for _, way in found]
    node, depth = model.ids[found[int(np.argmax(depths))][0]], max(depths)
    if not (kept or automatic):
        raise entry.error("surfa", f"node {node} begins {depth:.4g} behind the surface; move it to the front")
    what = "kept as offsets of the gap (IGNORE)" if kept else "moved to the surface"
    count = f"{len(found)} node{'s' if len(found) > 1 else ''}"
    model.facts[f"Initial penetrations of {contact.name}"] = (
        f"{count}, the deepest {node} by {depth:.4g}: {what}"
    )
    if kept:
        return
    for row, _ in found:
        if row in rigid:
            what = f"node {model.ids[row]} of a rigid part begins behind the surface; move the part, or set IGNORE = 1"
            raise entry.error("surfa", what)
    for tracked in passes:  # the second side of a two-way contact sees where the first has gone
        for row, way in contact.initial_penetrations(model.state.x):
            if row in tracked.nodes:
                model.state.x[row] += way
                model.x0[row] = model.state.x[row]
