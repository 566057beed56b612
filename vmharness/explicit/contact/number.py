"""The number by which a contact is known: CID, or its place among the contacts of the deck."""

from vmharness.deck import Deck, Entry


def contacts_of(deck: Deck) -> list[Entry]:
    """All contacts of the deck, in its order."""
    return [entry for entry in deck.entries if entry.keyword.name.startswith("CONTACT_")]


def number_of(deck: Deck, entry: Entry) -> int:
    """CID or place of a contact; raises DeckError where another has the same."""
    contacts = contacts_of(deck)
    numbers = [other.cid or place for place, other in enumerate(contacts, 1)]
    number = entry.cid or contacts.index(entry) + 1
    if numbers.count(number) > 1:
        raise entry.error("cid", "another contact has this number; give each its own by _ID")
    return number
