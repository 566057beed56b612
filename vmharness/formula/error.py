"""Errors in formulas and units."""

from collections.abc import Iterable
from difflib import get_close_matches


class FormulaError(Exception):
    """A formula that cannot be read, whose units do not agree, or that has no finite value."""


class UnitError(Exception):
    """A unit that cannot be read, or a system of units that is not consistent."""


def suggestion(word: str, known: Iterable[str]) -> str:
    """What to write instead of `word`: near names if there are any, else all that are known.

    >>> suggestion("omga", ["omega", "g"])
    'did you mean omega?'
    >>> suggestion("z", ["omega", "g"])
    'known: g, omega'
    """
    names = sorted(known)
    near = get_close_matches(word, names, n=3)
    if near:
        return f"did you mean {' or '.join(near)}?"
    return f"known: {', '.join(names) or 'none'}"
