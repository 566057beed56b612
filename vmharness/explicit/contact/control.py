"""*CONTROL_CONTACT: what holds for every contact of the deck."""

from collections.abc import Mapping
from typing import Any

from vmharness.deck import Deck
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT


def control_of(deck: Deck) -> Mapping[str, Any]:
    """The fields of *CONTROL_CONTACT by name, with their defaults where the deck has none."""
    control = deck.first(CONTROL_CONTACT)
    if control:
        return control.values
    return {name: value for card in CONTROL_CONTACT.cards for name, value in card.defaults().items()}
