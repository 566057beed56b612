"""The numbers of a deck's rigid bodies: PID of rigid parts and of nodal rigid bodies."""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.nodal_rigid_body import (
    CONSTRAINED_NODAL_RIGID_BODY,
    CONSTRAINED_NODAL_RIGID_BODY_INERTIA,
)
from vmharness.deck.keywords.constrained.rigid_bodies import CONSTRAINED_RIGID_BODIES
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART


def definitions(deck: Deck) -> list[Entry]:
    """Each *PART with *MAT_RIGID, then each nodal rigid body."""
    rigid = {entry.mid for entry in deck.all(MAT_RIGID)}
    parts = [part for part in deck.all(PART) if part.mid in rigid]
    return parts + deck.all(CONSTRAINED_NODAL_RIGID_BODY, CONSTRAINED_NODAL_RIGID_BODY_INERTIA)


def numbers(deck: Deck) -> list[int]:
    """The number of every rigid body, without those that join another."""
    merged = leads(deck)
    return [entry.pid for entry in definitions(deck) if entry.pid not in merged]


def leads(deck: Deck) -> dict[int, int]:
    """PIDC -> PIDL of *CONSTRAINED_RIGID_BODIES."""
    return {entry.pidc: entry.pidl for entry in deck.all(CONSTRAINED_RIGID_BODIES)}


def lead_number(deck: Deck, entry: Entry, field: str) -> int:
    """The number of the body that the rigid part or nodal rigid body `field` of `entry` is, or has joined."""
    number = body_number(deck, entry, field)
    return leads(deck).get(number, number)


def body_number(deck: Deck, entry: Entry, field: str) -> int:
    """The number of a rigid body that `field` of `entry` names; raises DeckError where there is none such."""
    number = int(getattr(entry, field))
    known = [other.pid for other in definitions(deck)]
    if number not in known:
        raise entry.error(field, f"no rigid body {number}; there are: {', '.join(map(str, known)) or 'none'}")
    return number
