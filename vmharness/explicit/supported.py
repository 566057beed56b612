"""What the solver supports of the keywords, and what it says of a deck: gathered from the modules that declare it."""

from functools import cache
from importlib import import_module
from pkgutil import walk_packages

import vmharness.explicit
from vmharness.deck import Deck, support
from vmharness.deck.finding import Finding
from vmharness.deck.support import Supported
from vmharness.explicit.references import review_references


@cache
def supported() -> Supported:
    """SUPPORTS of all modules of the solver, by the names of the keywords."""
    packages = walk_packages(vmharness.explicit.__path__, f"{vmharness.explicit.__name__}.")
    modules = [import_module(package.name) for package in packages]
    return support.by_name(each for module in modules for each in getattr(module, "SUPPORTS", ()))


def review_cards(deck: Deck) -> list[Finding]:
    """What of the cards is not supported, not defined, or without effect; no model is built."""
    found = support.review(deck, supported())
    return found + review_references(deck, supported(), found)


def notes(deck: Deck) -> list[str]:
    """A sentence for each keyword of the deck that cannot change results."""
    return support.effects(deck, supported())
