"""Build the contacts of a keyword: each entry *CONTACT_... -> its force in the model."""

from dataclasses import dataclass

import numpy as np

from vmharness.deck import Deck, Entry, Keyword
from vmharness.deck.error import each
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.explicit.contact.cards import (
    contacts_of,
    control_of,
    keeps_penetrations,
    number_of,
    options_of,
)
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.initial_penetration import treat_initial_penetrations
from vmharness.explicit.contact.records import Segments, Tracked
from vmharness.explicit.contact.sides import Sides
from vmharness.explicit.contact.surface.faces import contact_faces
from vmharness.explicit.contact.without_effect import of_contact, of_control
from vmharness.explicit.model.model import Model


@dataclass(frozen=True)
class Kind:
    """Properties of a contact keyword."""

    keyword: Keyword
    automatic: bool = False  # thickness counts, and contact with shells is on both sides
    two_way: bool = False  # nodes of B are tracked against segments of A too
    single_surface: bool = False  # surface A is tracked against itself


def add_contacts(deck: Deck, model: Model, kind: Kind) -> None:
    """Add a force for each contact of this kind in the deck."""
    entries = deck.all(kind.keyword)
    if not entries:
        return
    every, control = contact_faces(deck, model), control_of(deck)
    rigid = np.unique(every.nodes[every.rigid])

    def add(entry: Entry) -> None:
        sides = Sides(deck, model, entry, control, every, kind.automatic, kind.single_surface)
        passes = passes_of(sides, kind.two_way)
        contact = Contact(number_of(deck, entry), passes, options_of(entry, control))
        tracked, kept = [tracked for tracked, _ in passes], keeps_penetrations(entry, control)
        treat_initial_penetrations(contact, tracked, model, entry, kept, kind.automatic, rigid)
        model.facts |= of_contact(deck, entry, control, kind.two_way)
        model.forces.append(contact)

    each(entries, add)


def passes_of(sides: Sides, two_way: bool) -> list[tuple[Tracked, Segments]]:
    """Which nodes are tracked against which segments."""
    if sides.single:
        faces = sides.faces("a")
        nodes = np.unique(faces.nodes)
        return [(sides.tracked("a", nodes), sides.segments("a", faces, nodes))]
    nodes, faces = sides.nodes("a"), sides.faces("b")
    passes = [(sides.tracked("a", nodes), sides.segments("b", faces, nodes))]
    if two_way:
        back = np.unique(faces.nodes)
        passes.append((sides.tracked("b", back), sides.segments("a", sides.faces("a"), back)))
    return passes


def report_control(deck: Deck, model: Model) -> None:
    """Add to the facts what of *CONTROL_CONTACT acts on no contact of the deck."""
    control = deck.first(CONTROL_CONTACT)
    if control:
        model.facts |= of_control(control, contacts_of(deck))
