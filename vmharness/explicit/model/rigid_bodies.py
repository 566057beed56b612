"""Which rigid bodies a deck defines: parts of *MAT_RIGID and nodal rigid bodies, merged by *CONSTRAINED_RIGID_BODIES.

The number of a body is its PID. A body that is merged into another has that body's number.
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.extra_nodes import (
    CONSTRAINED_EXTRA_NODES_NODE,
    CONSTRAINED_EXTRA_NODES_SET,
)
from vmharness.deck.keywords.constrained.nodal_rigid_body import (
    CONSTRAINED_NODAL_RIGID_BODY,
    CONSTRAINED_NODAL_RIGID_BODY_INERTIA,
)
from vmharness.deck.keywords.constrained.rigid_bodies import CONSTRAINED_RIGID_BODIES
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART, has_inertia
from vmharness.deck.rule import above, among, anything, at_least, no_effect, only, where
from vmharness.deck.support import supports
from vmharness.explicit.state import Flags
from vmharness.mesh.dof import coded

OF_BODY = {
    "cid": only(0, idle=lambda deck, entry: "of output alone"),
    "nsid": at_least(0),
    "pnode": only(0, idle=lambda deck, entry: "of output alone"),
    "iprt": no_effect("of output alone"),
    "drflag": only(0),
    "rrflag": only(0),
}

SUPPORTS = (
    supports(CONSTRAINED_NODAL_RIGID_BODY, **OF_BODY),
    supports(
        CONSTRAINED_NODAL_RIGID_BODY_INERTIA,
        **OF_BODY,
        tm=above(0.0),
        ircs=among(0, 1),
        nodeid=at_least(0),
        **{
            name: anything(where(lambda entry: entry.nodeid, "NODEID gives the centre"))
            for name in ("xc", "yc", "zc")
        },
        **{name: at_least(0.0) for name in ("ixx", "iyy", "izz")},
        cid2=only(0),
    ),
    supports(CONSTRAINED_EXTRA_NODES_NODE, iflag=only(0)),
    supports(CONSTRAINED_EXTRA_NODES_SET, iflag=only(0)),
    supports(CONSTRAINED_RIGID_BODIES, iflag=only(0)),
)


def definitions(deck: Deck) -> list[Entry]:
    """Each *PART with *MAT_RIGID, then each nodal rigid body."""
    rigid = {entry.mid for entry in deck.all(MAT_RIGID)}
    parts = [part for part in deck.all(PART) if part.mid in rigid]
    return parts + deck.all(CONSTRAINED_NODAL_RIGID_BODY, CONSTRAINED_NODAL_RIGID_BODY_INERTIA)


def body_numbers(deck: Deck) -> list[int]:
    """The number of every rigid body, without those that are merged into another."""
    merged = lead_bodies(deck)
    return [entry.pid for entry in definitions(deck) if entry.pid not in merged]


def lead_bodies(deck: Deck) -> dict[int, int]:
    """PIDC -> PIDL of *CONSTRAINED_RIGID_BODIES: the body into which each is merged."""
    return {entry.pidc: entry.pidl for entry in deck.all(CONSTRAINED_RIGID_BODIES)}


def lead_number(deck: Deck, entry: Entry, field: str) -> int:
    """The number of the body that `field` of `entry` names, or of the one into which that is merged."""
    number = body_number(deck, entry, field)
    return lead_bodies(deck).get(number, number)


def body_number(deck: Deck, entry: Entry, field: str) -> int:
    """The number of a rigid body that `field` of `entry` names; raises DeckError where there is none such."""
    number = int(getattr(entry, field))
    known = [other.pid for other in definitions(deck)]
    if number not in known:
        raise entry.error(field, f"no rigid body {number}; there are: {', '.join(map(str, known)) or 'none'}")
    return number


def gives_inertia(definition: Entry) -> bool:
    """True if the definition gives mass, inertia and velocity: *PART_INERTIA, or the nodal rigid body's _INERTIA."""
    return definition.keyword is CONSTRAINED_NODAL_RIGID_BODY_INERTIA or has_inertia(definition)


def held_by_cmo(deck: Deck, definition: Entry) -> Flags:
    """Degrees of freedom (6,) that CMO of *MAT_RIGID fixes: translations of the centre, rotations."""
    held = np.zeros(6, bool)
    if definition.keyword is PART:
        material = deck.find(MAT_RIGID, mid=definition.mid)
        if material.cmo == 1:
            for offset, code in ((0, material.con1), (3, material.con2)):
                held[[offset + axis for axis in coded(code)]] = True
    return held
