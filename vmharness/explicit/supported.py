"""What the solver supports of the keywords, and what it says of a deck: gathered from the modules that declare it."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache
from importlib import import_module
from pkgutil import walk_packages

import vmharness.explicit
from vmharness.deck import Deck, DeckError, Entry, support
from vmharness.deck.finding import Finding
from vmharness.deck.support import Supported
from vmharness.explicit.references.cards import review_references


@cache
def supported() -> Supported:
    """SUPPORTS of all modules of the solver, by the names of the keywords."""
    packages = walk_packages(vmharness.explicit.__path__, f"{vmharness.explicit.__name__}.")
    modules = [import_module(package.name) for package in packages]
    return support.by_name(each for module in modules for each in getattr(module, "SUPPORTS", ()))


def review_cards(deck: Deck) -> list[Finding]:
    """What of the cards is not supported, not defined, or without effect; no model is built."""
    if not deck.sound:
        deck = replace(deck, entries=[entry for entry in deck.entries if _has_rows(entry)], _by_name={})
    found = support.review(deck, supported())
    return found + review_references(deck, supported(), found)


def _has_rows(entry: Entry) -> bool:
    """Whether all columns of the entry could be read, if it is a table."""
    rows = [getattr(card, "flat", "") or card.defaults() for card in entry.keyword.rows]
    columns = {name for names in rows for name in ([names] if isinstance(names, str) else names)}
    one_line = entry.keyword.one_line
    return columns <= entry.values.keys() or bool(
        one_line and one_line.defaults().keys() <= entry.values.keys()
    )


def notes(findings: Iterable[Finding], facts: Mapping[str, str]) -> list[str]:
    """A sentence for each keyword and field without effect, each once; without those that are among the facts."""
    told = "; ".join(fact for name, fact in facts.items() if name.startswith("Without effect"))
    said: dict[str, int] = {}
    for error in (finding.error for finding in findings if finding.idle):
        if f"{error.field.upper()} = {error.value} ({error.what})" not in told:
            sentence = str(DeckError(error.what, "", 0, error.keyword, error.field, error.value))
            said[sentence] = said.get(sentence, 0) + 1
    return [sentence + (f" ({count} such cards)" if count > 1 else "") for sentence, count in said.items()]
