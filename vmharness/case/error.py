"""Errors in a case, with their place in the file and with similar names."""

from collections.abc import Iterable
from difflib import get_close_matches


class CaseError(Exception):
    """A case folder that cannot be used: `case.toml: [results] 3: what is wrong`."""


def near(name: str, known: Iterable[str]) -> str:
    """The end of a message about an unknown name: similar known names, or all of them.

    >>> near("tolerence", ["tolerance", "target"])
    '; did you mean tolerance?'
    """
    known = list(known)
    found = get_close_matches(name, known, n=2, cutoff=0.6)
    return f"; did you mean {' or '.join(found)}?" if found else f"; there are: {', '.join(known) or 'none'}"
