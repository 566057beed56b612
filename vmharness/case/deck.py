"""The deck of a case as it runs, read with the keywords that there are."""

from vmharness.case.case import Case
from vmharness.deck import Deck, read, vocabulary


def read_deck(case: Case) -> Deck:
    """The case's deck, with its parameters replaced where the data were changed, or the one set in its place.

    Raises CaseError where a template makes no deck, and DeckError where the deck is wrong.
    """
    return read(
        case.folder / case.deck_name,
        vocabulary(),
        parameters=case.deck_parameters(),
        include_outside=case.file.deck.include_outside,
        text=case.deck_source(),
    )
