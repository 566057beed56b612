"""*PART: what elements share: section, material, hourglass control; _INERTIA: mass and inertia of a rigid one.

_CONTACT adds friction and thickness for contacts; _TITLE is *PART itself, which has a heading anyway.
"""

from vmharness.deck.card import Card
from vmharness.deck.entry import Entry
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords._inertia import CENTRE, LOCAL, TENSOR, VELOCITY

CONTACT = ("fs", "fd", "dc", "vc", "optt", "sft", "ssf", "cparm8")


def has_inertia(entry: Entry) -> bool:
    """Whether the part is one of *PART_INERTIA."""
    return entry.suffix == "INERTIA"


HEADING = Card(heading=text("", width=70))

DATA = Card(
    pid=integer(above=0),
    secid=integer(above=0),
    mid=integer(above=0),
    eosid=integer(0),
    hgid=integer(0),
    grav=integer(0),
    adpopt=integer(0),
    tmid=integer(0),
)

PART = Keyword(
    "PART",
    HEADING,
    DATA,
    Card(CENTRE, when=has_inertia),
    Card(TENSOR, when=has_inertia),
    Card(VELOCITY, when=has_inertia),
    Card(LOCAL, when=lambda entry: has_inertia(entry) and entry.ircs == 1),
    options={"INERTIA": Card(), "TITLE": Card()},
    repeat=True,
    unique="pid",
    kind="part",
)

PART_CONTACT = Keyword(
    "PART_CONTACT",
    HEADING,
    DATA,
    Card({name: real(0.0) for name in CONTACT}),
    repeat=True,
    unique="pid",
    kind="part",
)
