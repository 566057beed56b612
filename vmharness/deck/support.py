"""What a solver supports of the keywords, declared as data, and a deck reviewed by it.

    SUPPORTS = (supports(MAT_ELASTIC, da=only(0.0), db=only(0.0)),)

A field without a rule may have any value. A keyword that is not declared is not supported.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.deck.deck import Deck
from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError
from vmharness.deck.finding import Finding
from vmharness.deck.keyword import Keyword
from vmharness.deck.misspelling import misspelling_of
from vmharness.deck.rule import Rule, Why


@dataclass(frozen=True, slots=True)
class Support:
    """What a solver does with a keyword: `rules` by field.

    `effect`: for a keyword that cannot change results, a sentence that says so. `idle`: as of a rule, for all fields
    that have no such sentence of their own.
    """

    keyword: Keyword
    rules: Mapping[str, Rule]
    effect: str = ""
    idle: Why | None = None


def supports(keyword: Keyword, idle: Why | None = None, /, **rules: Rule) -> Support:
    """Declare a keyword as supported, with rules for some of its fields, and why none acts in some decks."""
    fields = {name for card in keyword.all_cards() for name in card.defaults()}
    if strange := rules.keys() - fields:
        raise ValueError(f"{keyword!r} has no field {', '.join(sorted(strange))}")
    return Support(keyword, rules, idle=idle)


def without_effect(keyword: Keyword, sentence: str, /, **rules: Rule) -> Support:
    """Declare that a keyword cannot change results; `rules` are for what it could ask for that is not so."""
    return replace(supports(keyword, **rules), effect=sentence)


Supported = Mapping[str, Support]


def by_name(supported: Iterable[Support]) -> dict[str, Support]:
    """Declarations by the names of their keywords; raises ValueError where one is declared twice."""
    found: dict[str, Support] = {}
    for support in supported:
        if found.setdefault(support.keyword.name, support) is not support:
            raise ValueError(f"what is supported of {support.keyword!r} is declared twice")
    return found


def review(deck: Deck, supported: Supported) -> list[Finding]:
    """What of a deck is not supported, and what has no effect in it; in the order of the deck.

    Of the keywords that cannot change results each is named once.
    """
    found: list[Finding] = []
    named: set[str] = set()
    for entry in deck.entries:
        support = supported.get(entry.keyword.name)
        if support is None:
            found.append(Finding(entry.error(None, _unknown(entry, supported))))
            continue
        if support.effect and entry.keyword.name not in named:
            found.append(Finding(entry.error(None, support.effect), idle=True))
            named.add(entry.keyword.name)
        found += _fields(deck, entry, support)
    return found


def effects(deck: Deck, supported: Supported) -> list[str]:
    """A sentence for each keyword of the deck that cannot change results."""
    said = {
        f"*{entry.keyword.name}: {support.effect}": None
        for entry in deck.entries
        if (support := supported.get(entry.keyword.name)) and support.effect
    }
    return list(said)


def _unknown(entry: Entry, supported: Supported) -> str:
    """What to say of a keyword that is not declared."""
    if entry.raw is None:
        return "the keyword is not supported"
    known = {name for support in supported.values() for name in support.keyword.names()}
    meant = misspelling_of(entry.spelled, known)
    return "unknown keyword" + (f"; did you mean *{meant}?" if meant else "")


def _fields(deck: Deck, entry: Entry, support: Support) -> Iterator[Finding]:
    """What of one entry has no effect, or is not supported."""
    for name, rule in support.rules.items():
        values: Any = entry.values.get(name)
        if values is None:  # on a card that is not there
            continue
        idle = rule.idle or support.idle
        given = np.atleast_1d(values != entry.keyword.default(name))
        wrong = ~np.atleast_1d(rule.allows(values))
        if idle and given.any() and (why := idle(deck, entry)):
            yield Finding(_error(entry, name, why, given), idle=True)
        elif wrong.any():
            yield Finding(_error(entry, name, rule.what, wrong))
        elif rule.alike and given.any() and (why := rule.alike(deck, entry)):
            yield Finding(_error(entry, name, why, given), idle=True)


def _error(entry: Entry, name: str, what: str, rows: NDArray[np.bool_]) -> DeckError:
    """What there is to say of the first of the `rows` of a field, or of its only value."""
    if not isinstance(entry.values[name], np.ndarray):
        return entry.error(name, what)
    others = f" ({rows.sum()} such rows)" if rows.sum() > 1 else ""
    return entry.error(name, what + others, int(np.argmax(rows)))
