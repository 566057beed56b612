"""Near names for error messages."""

from collections.abc import Iterable
from difflib import get_close_matches


def near(name: str, known: Iterable[str]) -> str:
    """What to say after an unknown name: the nearest known ones, or all of them.

    >>> near("tolerence", ["tolerance", "target"])
    '; did you mean tolerance?'
    """
    known = list(known)
    found = get_close_matches(name, known, n=2, cutoff=0.6)
    return f"; did you mean {' or '.join(found)}?" if found else f"; there are: {', '.join(known) or 'none'}"
