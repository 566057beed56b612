"""Limits that contacts have reached, said after a run.

A node deeper than the depth of release (PENMAX, PENCHK) is released. A node has at most MAX_CONTACTS active contacts:
no other begins. A contact crosses at most MAX_CROSSINGS borders of segments in one step: tracking stops there, and
where the node is still farther, the contact ends.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.records import MAX_CONTACTS
from vmharness.explicit.contact.tracking import MAX_CROSSINGS
from vmharness.explicit.model.model import Model

Ids = NDArray[np.int64]


def limits_reached(model: Model) -> dict[str, str]:
    """The facts, by name, of all contacts that have reached a limit."""
    facts = {}
    for contact in model.forces:
        if isinstance(contact, Contact):
            ids = model.ids[contact.tracked]
            released, full, slides = (
                np.concatenate([one.nodes[name] for one in contact.passes])
                for name in ("released", "full_cycles", "long_slides")
            )
            if released.any():
                facts[f"Let through by {contact.name}"] = _released(ids[released])
            if full.any():
                facts[f"Contact limit reached in {contact.name}"] = _full(ids, full)
            if slides.any():
                facts[f"Border limit reached in {contact.name}"] = _slides(int(slides.sum()))
    return facts


def _released(ids: Ids) -> str:
    """Nodes released for their depth, those included that came so deep in one step."""
    nodes = np.unique(ids)
    count = _count(nodes.size, "node") if nodes.size > 1 else "one node"
    return f"{count}, first of them {nodes[0]}: deeper than PENMAX or PENCHK allows"


def _full(ids: Ids, cycles: Ids) -> str:
    """Nodes that needed more contacts than they can have; the one named did in most cycles."""
    most = int(np.argmax(cycles))
    others = int(np.unique(ids[cycles > 0]).size) - 1
    return (
        f"node {ids[most]} had more than {MAX_CONTACTS} contacts in {_count(int(cycles[most]), 'cycle')}"
        + (f"; so had {_count(others, 'other node')}" if others else "")
    )


def _slides(times: int) -> str:
    """Contacts that crossed so many borders that tracking stopped."""
    count = _count(times, "time")
    return (
        f"{MAX_CROSSINGS} segment borders were crossed in one step {count}; such a contact can end too early"
    )


def _count(n: int, noun: str) -> str:
    """The number with its noun.

    >>> _count(1, "cycle"), _count(3, "cycle")
    ('1 cycle', '3 cycles')
    """
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"
