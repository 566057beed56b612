"""Of which quantities of result files a channel of a case is made, whatever the format.

Signs and sides. A contact's force is that on side A (SURFA, formerly slave). Reactions of supports, prescribed motions
and joints are forces on the nodes, as LS-DYNA prints them. The force of a wall without friction is its normal force
along the normal of the deck, whatever sign the file gives to x-force. The stress of a truss is its force over the area
of the deck.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vmharness.case.format import Channel
from vmharness.deck import Deck, DeckError, Entry
from vmharness.deck.keywords.boundary.prescribed_motion import (
    BOUNDARY_PRESCRIBED_MOTION_NODE,
    BOUNDARY_PRESCRIBED_MOTION_SET,
)
from vmharness.mesh.nodes import nodes_of
from vmharness.mesh.sets import node_set
from vmharness.results._key import Key, Sum

MOTIONS = (BOUNDARY_PRESCRIBED_MOTION_NODE, BOUNDARY_PRESCRIBED_MOTION_SET)
AXES = ("x", "y", "z")
MIXED = "cannot be told apart: LS-DYNA writes the energies of a contact and of its friction as one"


@dataclass(frozen=True)
class Quantities:
    """What a channel can be made of: sums of quantities, the best first; and why others are not, in sentences."""

    sums: list[Sum] = field(default_factory=list)
    reasons: list[str] = field(default_factory=list)


class _CannotError(Exception):
    """A channel has no counterpart in result files, and why."""


def quantities(name: str, channel: Channel, deck: Deck) -> Quantities:
    """The sums of quantities that are the channel `name`; the last is a column of that name."""
    column: Sum = {Key("column", name): 1.0}
    try:
        return Quantities([*_of(channel)(channel, deck), column])
    except _CannotError as error:
        return Quantities([column], [str(error)])
    except DeckError as error:
        return Quantities([column], [f"the deck does not say what it is: {error}"])


def _of(channel: Channel) -> "Callable[[Channel, Deck], Iterator[Sum]]":
    """The function for the owner of the channel; a node beside another owner is a place."""
    owners = {
        "contact": _contact, "wall": _wall, "centre": _centre, "support": _support, "motion": _motion,
        "rigid": _plain, "joint": _plain, "energy": _energy, "shell": _element, "solid": _element, "beam": _element,
        "discrete": _element, "node": _plain,
    }  # fmt: skip
    return next(function for owner, function in owners.items() if getattr(channel, owner) is not None)


def _plain(channel: Channel, deck: Deck) -> Iterator[Sum]:
    owner = next(owner for owner in ("rigid", "joint", "node") if getattr(channel, owner) is not None)
    yield {Key(owner, channel.component or "", getattr(channel, owner)): 1.0}


def _element(channel: Channel, deck: Deck) -> Iterator[Sum]:
    owner = next(
        owner for owner in ("shell", "solid", "beam", "discrete") if getattr(channel, owner) is not None
    )
    eid, component = getattr(channel, owner), channel.component or ""
    yield {Key(owner, component, eid, 0 if owner == "discrete" else channel.point or 1): 1.0}
    if owner == "beam":
        yield {Key(owner, component, eid): 1.0}  # a resultant has no point
        if component == "axial-stress" and (area := _area(deck, eid)):
            yield {Key(owner, "axial-force", eid): 1.0 / area}


def _area(deck: Deck, eid: int) -> float:
    """The area of the cross-section of a truss or resultant beam; 0 for others."""
    for table in deck.all("ELEMENT_BEAM", "ELEMENT_BEAM_ORIENTATION"):
        for pid in table.pid[table.eid == eid]:
            part = next(
                part for part in deck.entries if part.values.get("pid") == pid and "secid" in part.values
            )
            return float(deck.find("SECTION_BEAM", secid=part.secid).values.get("a", 0.0))
    return 0.0


def _energy(channel: Channel, deck: Deck) -> Iterator[Sum]:
    energy = channel.energy or ""
    if channel.part is not None:
        yield {Key("part", energy, channel.part): 1.0}
    elif energy in ("contact", "friction", "released"):
        yield {Key("energy", energy): 1.0}
        if energy != "contact" or _rubs(deck):
            raise _CannotError(MIXED)
        yield {Key("energy", "sliding"): 1.0}
    else:
        yield {Key("energy", energy): 1.0}


def _rubs(deck: Deck, number: int = 0) -> bool:
    """Whether the contact with this number, or any, has friction."""
    return any(entry.fs or entry.fd for place, entry in _contacts(deck) if number in (0, entry.cid or place))


def _contacts(deck: Deck) -> Iterator[tuple[int, Entry]]:
    return enumerate((entry for entry in deck.entries if entry.keyword.name.startswith("CONTACT_")), 1)


def _contact(channel: Channel, deck: Deck) -> Iterator[Sum]:
    number, component = channel.contact or 0, channel.component or ""
    if channel.node is not None:
        yield {Key("node in contact", component, channel.node): 1.0}
    elif component == "friction energy" or (component == "energy" and _rubs(deck, number)):
        raise _CannotError(MIXED)
    else:
        yield {Key("contact", component, number): 1.0}


def _wall(channel: Channel, deck: Deck) -> Iterator[Sum]:
    number = channel.wall or 0
    along, _, quantity = (channel.component or "").partition("-")
    if quantity != "force" or along == "normal":
        yield {Key("wall", channel.component or "", number): 1.0}
        return
    entry = next((e for n, e in _walls(deck) if (e.values.get("id") or n) == number), None)
    if entry is None:
        raise _CannotError(f"the deck has no rigid wall {number}")
    if entry.fric:
        raise _CannotError(
            "with friction the force of the wall has parts that the normal force does not give"
        )
    yield {Key("wall", "normal-force", number): float(_normal(entry)[AXES.index(along)])}


def _walls(deck: Deck) -> Iterator[tuple[int, Entry]]:
    return enumerate(
        (entry for entry in deck.entries if entry.keyword.name.startswith("RIGIDWALL_PLANAR")), 1
    )


def _normal(wall: Entry) -> NDArray[np.float64]:
    """The outward unit normal, from the tail to the head of the vector on the card."""
    n = np.array([wall.xh - wall.xt, wall.yh - wall.yt, wall.zh - wall.zt])
    return np.asarray(n / np.linalg.norm(n))


def _support(channel: Channel, deck: Deck) -> Iterator[Sum]:
    number = 0 if channel.support == "all" else int(channel.support or 0)
    yield {Key("support", channel.component or "", number): 1.0}


def _motion(channel: Channel, deck: Deck) -> Iterator[Sum]:
    entries = [entry for entry in deck.entries if entry.keyword in MOTIONS]
    number = channel.motion or 0
    if not 1 <= number <= len(entries):
        raise _CannotError(f"the deck has no prescribed motion {number}")
    entry = entries[number - 1]
    if entry.keyword is BOUNDARY_PRESCRIBED_MOTION_NODE:
        ids = [entry.nid]
    else:
        nodes = nodes_of(deck)
        ids = nodes.ids[node_set(deck, nodes, entry, "nsid")].tolist()
    yield {Key("driven node", channel.component or "", nid): 1.0 for nid in ids}


def _centre(channel: Channel, deck: Deck) -> Iterator[Sum]:
    component = channel.component or ""
    if channel.centre != "all":
        yield {Key("part", component, int(channel.centre or 0)): 1.0}
        return
    yield {Key("model", component): 1.0}
    if not component.endswith("-momentum"):
        return
    if any(not pid for table in deck.all("ELEMENT_MASS") for pid in np.atleast_1d(table.pid)):
        raise _CannotError("nodal masses that belong to no part are in the momentum of no part")
    pids = [
        entry.pid
        for entry in deck.entries
        if "secid" in entry.values and isinstance(entry.values.get("pid"), int)
    ]
    yield {Key("part", component, pid): 1.0 for pid in pids}
