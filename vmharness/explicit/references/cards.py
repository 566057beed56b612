"""References of cards, reviewed before a model is built: each number that a card names is defined in the deck.

A field that has a name of BY_NAME refers to what stands there, in every keyword but those that define it; what a
keyword has otherwise stands in OTHERS. The surfaces of contacts, and ID of *INITIAL_VELOCITY_GENERATION, refer to what
another field says. 0 refers to nothing. Of a set that is used, the members are reviewed, too.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import cache

import numpy as np

from vmharness.deck import Deck, DeckError, Entry, Keyword
from vmharness.deck.finding import Finding, unsupported
from vmharness.deck.support import Supported
from vmharness.explicit.contact.without_effect import kinds
from vmharness.explicit.references.defined import (
    CURVE,
    NODE_SETS,
    NODES,
    ORIENTATIONS,
    PART_SETS,
    PART_SETS_OF_SURFACES,
    PARTS,
    RIGID_BODIES,
    SEGMENT_SETS,
    SHELL_SETS,
    SHELLS,
    Defined,
    Kind,
)
from vmharness.explicit.references.parts import missing_of_parts
from vmharness.mesh import surface

BY_NAME: Mapping[str, Kind] = {
    **dict.fromkeys(("lcid", "lctm", "lcss", "lcsr", "lcd", "lcdr"), CURVE),
    **dict.fromkeys(("nsid", "nsidex"), NODE_SETS),
    "nid": NODES,
    "pid": PARTS,
    "psid": PART_SETS,
    "ssid": SEGMENT_SETS,
    "vid": ORIENTATIONS,
}

FOUR_NODES: Mapping[str, Kind] = {f"n{i}": NODES for i in range(1, 5)}
OF_BODY: Mapping[str, Kind] = {"pid": RIGID_BODIES}

OTHERS: Mapping[str, Mapping[str, Kind | None]] = {
    "LOAD_RIGID_BODY": OF_BODY,
    "BOUNDARY_PRESCRIBED_MOTION_RIGID": OF_BODY,
    "INITIAL_VELOCITY_RIGID_BODY": OF_BODY,
    "CONSTRAINED_EXTRA_NODES_NODE": OF_BODY,
    "CONSTRAINED_EXTRA_NODES_SET": OF_BODY,
    "CONSTRAINED_RIGID_BODIES": {"pidl": RIGID_BODIES, "pidc": RIGID_BODIES},
    "CONSTRAINED_JOINT_SPHERICAL": {"n1": NODES, "n2": NODES},
    "CONSTRAINED_JOINT_REVOLUTE": FOUR_NODES,
    "CONSTRAINED_NODAL_RIGID_BODY": {"pid": None},  # which it defines
    "CONSTRAINED_NODAL_RIGID_BODY_INERTIA": {"pid": None},
    "DATABASE_HISTORY_NODE": {"ids": NODES},
    "DATABASE_HISTORY_NODE_ID": {"id1": NODES},
    "DATABASE_HISTORY_NODE_SET": {"ids": NODE_SETS},
    "ELEMENT_MASS": {"pid": None},  # is not used
    "LOAD_SEGMENT": FOUR_NODES,
}

MEMBERS: Mapping[Kind, Mapping[str, Kind]] = {
    NODE_SETS: {"nodes": NODES, "sets": NODE_SETS},
    PART_SETS: {"sets": PART_SETS},
    SEGMENT_SETS: FOUR_NODES,
    SHELL_SETS: {"shells": SHELLS},
    PART_SETS_OF_SURFACES: {"parts": PARTS, "sets": PART_SETS},
}

SURFACES: Mapping[int, Kind] = {
    surface.SEGMENT_SET: SEGMENT_SETS,
    surface.SHELL_SET: SHELL_SETS,
    surface.PART_SET: PART_SETS_OF_SURFACES,
    surface.ONE_PART: PARTS,
    surface.NODE_SET: NODE_SETS,
    surface.EXEMPT: PART_SETS_OF_SURFACES,
}
GENERATED: Mapping[int, Kind] = {1: PART_SETS, 2: PARTS, 3: NODE_SETS}  # STYP


def review_references(deck: Deck, supported: Supported, findings: Sequence[Finding]) -> list[Finding]:
    """What is referred to and not defined, unless it follows from the `findings` of the cards or stands among them."""
    before = unsupported(findings)
    places = {(error.file, error.line, error.field) for error in before}
    families = {error.keyword.partition("_")[0] for error in before if not error.field}
    return [
        Finding(error)
        for error in _missing(deck, supported)
        if (error.file, error.line, error.field) not in places and not error.sought & families
    ]


def _missing(deck: Deck, supported: Supported) -> Iterator[DeckError]:
    defined = Defined(deck)
    used: dict[Kind, set[int]] = {kind: set() for kind in MEMBERS}  # sets, by number
    for entry in deck.entries:
        support = supported.get(entry.keyword.name)
        if not support or (support.effect and entry.keyword.name not in OTHERS):
            continue
        for name, kind in _references(entry):
            yield from defined.missing(entry, name, kind, zero=entry.keyword in kinds())
            if kind in used:
                used[kind].update(np.atleast_1d(entry.values[name]).tolist())
    for kind, members in MEMBERS.items():
        for entry in deck.all(*kind.keywords) if used[kind] else ():
            for name in members if entry.sid in used[kind] else ():
                yield from defined.missing(entry, name, members[name])
    yield from missing_of_parts(deck, defined)


def _references(entry: Entry) -> Iterator[tuple[str, Kind]]:
    """The fields of an entry that refer to something, and to what."""
    yield from _fields(entry.keyword).items()
    if contact := kinds().get(entry.keyword):
        single = contact.single_surface
        for name in ["surfa"] if single else ["surfa", "surfb"]:
            kind = SURFACES.get(entry.values[f"{name}typ"])
            if kind and not (single and not entry.values[name]):
                yield name, kind
    elif entry.keyword.name == "INITIAL_VELOCITY_GENERATION" and entry.styp in GENERATED:
        yield "id", GENERATED[entry.styp]
    elif entry.keyword.name.startswith("CONSTRAINED_NODAL_RIGID_BODY") and not entry.nsid:
        yield "pid", NODE_SETS


@cache
def _fields(keyword: Keyword) -> Mapping[str, Kind]:
    """The fields that always refer to the same kind of thing."""
    names = {name for card in keyword.all_cards() for name in card.defaults()}
    usual = {name: kind for name, kind in BY_NAME.items() if name in names and keyword not in kind.keywords}
    found = {**usual, **dict.fromkeys(keyword.corners, NODES), **OTHERS.get(keyword.name, {})}
    return {name: kind for name, kind in found.items() if kind}
