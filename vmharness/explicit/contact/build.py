"""A *CONTACT_... card -> its force in the model."""

import numpy as np

from vmharness.deck import Deck, Keyword
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.control import control_of
from vmharness.explicit.contact.initial import treat
from vmharness.explicit.contact.number import number_of
from vmharness.explicit.contact.options import keeps_penetrations, options_of
from vmharness.explicit.contact.segments import Segments
from vmharness.explicit.contact.sides import Sides
from vmharness.explicit.contact.surface.facets import all_facets
from vmharness.explicit.contact.tracked import Tracked
from vmharness.explicit.contact.without_effect import of_contact
from vmharness.explicit.model.model import Model


def add_contacts(
    deck: Deck, model: Model, keyword: Keyword, two_way: bool = False, single: bool = False
) -> None:
    """Add a force for each such contact of the deck: A against B, in a two-way contact B against A too.

    In a single-surface contact A is tracked against itself. What is AUTOMATIC by name has thickness and two sides.
    """
    entries = deck.all(keyword)
    if not entries:
        return
    every, control = all_facets(deck, model), control_of(deck)
    rigid = np.unique(every.nodes[every.rigid])
    for entry in entries:
        automatic = "AUTOMATIC" in keyword.name
        passes = passes_of(Sides(deck, model, entry, control, every, automatic, single), two_way)
        contact = Contact(number_of(deck, entry), passes, options_of(entry, control))
        tracked = [tracked for tracked, _ in passes]
        treat(contact, tracked, model, entry, keeps_penetrations(entry, control), automatic, rigid)
        model.facts |= of_contact(deck, entry, control, two_way)
        model.forces.append(contact)


def passes_of(sides: Sides, two_way: bool) -> list[tuple[Tracked, Segments]]:
    """Which nodes are held against which segments."""
    if sides.single:
        facets = sides.facets("a")
        nodes = np.unique(facets.nodes)
        return [(sides.tracked("a", nodes), sides.segments("a", facets, nodes))]
    nodes, facets = sides.nodes("a"), sides.facets("b")
    passes = [(sides.tracked("a", nodes), sides.segments("b", facets, nodes))]
    if two_way:
        back = np.unique(facets.nodes)
        passes.append((sides.tracked("b", back), sides.segments("a", sides.facets("a"), back)))
    return passes
