"""*PART: what elements share: section, material, hourglass control; _INERTIA: mass and inertia of a rigid one."""

from vmharness.deck.card import Card
from vmharness.deck.entry import Entry
from vmharness.deck.field import integer, only, text
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords._inertia import CENTRE, LOCAL, TENSOR, VELOCITY


def has_inertia(entry: Entry) -> bool:
    """Whether the part is one of *PART_INERTIA."""
    return entry.suffix == "INERTIA"


PART = Keyword(
    "PART",
    Card(heading=text("", width=70)),
    Card(
        pid=integer(above=0),
        secid=integer(above=0),
        mid=integer(above=0),
        eosid=only(0),
        hgid=integer(0, at_least=0),
        grav=only(0),
        adpopt=only(0),
        tmid=only(0),
    ),
    Card(CENTRE, when=has_inertia),
    Card(TENSOR, when=has_inertia),
    Card(VELOCITY, when=has_inertia),
    Card(LOCAL, when=lambda entry: has_inertia(entry) and entry.ircs == 1),
    options={"INERTIA": Card()},
    repeat=True,
    unique="pid",
    kind="part",
)
