"""What a solver can do with the values of a field: rules for support.py, for numbers, texts and whole columns."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from vmharness.deck.deck import Deck
from vmharness.deck.entry import Entry

Why = Callable[[Deck, Entry], str]  # why a value has no effect in this deck; empty where it has


@dataclass(frozen=True, slots=True)
class Rule:
    """`allows(values)`: for each value whether it can be done; `what` says which can, `brief` lists them if few can.

    `idle`: why a value that is not the default has no effect in a deck, where that is so; then it is allowed, too.
    `alike`: the same, but of the values that are allowed only.
    """

    allows: Callable[[Any], Any]
    what: str
    brief: str
    idle: Why | None = None
    alike: Why | None = None


def among(*values: Any, idle: Why | None = None, what: str = "", alike: Why | None = None) -> Rule:
    """These values alone; `what` replaces the sentence that lists them.

    >>> among(0, 1, 2).what, among("MECH").what, among(0.0, 1e8).what
    ('only 0, 1 and 2 are supported', 'only MECH is supported', 'only 0.0 and 1e+08 are supported')
    """
    *others, last = map(_shown, values)
    sentence = f"only {', '.join(others)} and {last} are supported" if others else f"only {last} is supported"
    brief = f"only {', '.join(map(_shown, values))}"
    return Rule(lambda found: np.isin(found, values), what or sentence, brief, idle, alike)


def _shown(value: Any) -> str:
    """A value, large and small numbers with an exponent."""
    short = f"{value:g}" if isinstance(value, float) else ""
    return short if "e" in short else str(value)


def implemented(names: Mapping[int, str], idle: Why | None = None) -> Rule:
    """These values alone, such as those of ELFORM, with their names.

    >>> implemented({1: "one point", 2: "fully integrated"}).what
    'not implemented; supported: 1 (one point), 2 (fully integrated)'
    """
    named = ", ".join(f"{value} ({name})" for value, name in names.items())
    return among(*names, idle=idle, what=f"not implemented; supported: {named}")


def only(value: Any, idle: Why | None = None, what: str = "") -> Rule:
    """One value alone."""
    return among(value, idle=idle, what=what)


def above(limit: float, idle: Why | None = None, what: str = "") -> Rule:
    """Values greater than `limit`."""
    sentence = what or f"must be greater than {limit:g}"
    return Rule(lambda found: np.greater(found, limit), sentence, "", idle)


def at_least(limit: float, idle: Why | None = None, what: str = "") -> Rule:
    """Values not less than `limit`."""
    sentence = what or f"must be at least {limit:g}"
    return Rule(lambda found: np.greater_equal(found, limit), sentence, "", idle)


def between(low: float, high: float) -> Rule:
    """Values greater than `low` and less than `high`."""
    sentence = f"must lie between {low:g} and {high:g}"
    return Rule(lambda found: np.logical_and(found > low, found < high), sentence, "")


def anything(idle: Why) -> Rule:
    """Any value, though it may have no effect."""
    return Rule(lambda found: np.ones(np.shape(found), bool), "", "", idle)


def no_effect(sentence: str) -> Rule:
    """Any value: none has an effect, as the sentence says."""
    return anything(always(sentence))


def always(sentence: str) -> Why:
    """No effect in any deck, as the sentence says."""
    return lambda deck, entry: sentence


def unless(condition: Callable[[Deck], Any], sentence: str) -> Why:
    """No effect, as the sentence says, unless the deck has what `condition` looks for."""
    return lambda deck, entry: "" if condition(deck) else sentence


def where(condition: Callable[[Entry], Any], sentence: str) -> Why:
    """No effect, as the sentence says, beside other fields of the entry that meet the `condition`."""
    return lambda deck, entry: sentence if condition(entry) else ""


def without_parts(deck: Deck, section: Entry) -> str:
    """Why a field of a section has no effect: no part has this section."""
    used = any(part.secid == section.secid for part in deck.all("PART"))
    return "" if used else "no part has this section"


def without_deformable_parts(deck: Deck, section: Entry) -> str:
    """Why a field of a section has no effect: no part but rigid ones has this section."""
    rigid = {material.mid for material in deck.all("MAT_RIGID")}
    used = any(part.secid == section.secid and part.mid not in rigid for part in deck.all("PART"))
    return "" if used else "no deformable part has this section"
