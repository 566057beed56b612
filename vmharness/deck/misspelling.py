"""Which known keyword a name is a probable typing error of.

A keyword of LS-DYNA that is not known here is no typing error of one that is: *MAT_VISCOELASTIC of *MAT_ELASTIC,
*MAT_027 of *MAT_024, *SET_TSHELL of *SET_SHELL. So at most two letters may be wrong, no digit, and no word's first
letter.
"""

import re
from collections.abc import Iterable, Sequence

MOST = 2  # letters that are wrong
SHORT = 8  # letters of a word of which only one may be wrong


def misspelling_of(name: str, known: Iterable[str]) -> str:
    """The known name that differs least from `name`, if it is probably meant; else empty.

    >>> misspelling_of("MAT_ELASTICK", ["MAT_RIGID", "MAT_ELASTIC"])
    'MAT_ELASTIC'
    >>> misspelling_of("MAT_VISCOELASTIC", ["MAT_RIGID", "MAT_ELASTIC"])
    ''
    """
    near = {other: _edits_of_words(name.split("_"), other.split("_")) for other in known}
    best = min(near, key=lambda other: (near[other], other), default="")
    return best if best and near[best] <= MOST else ""


def _edits_of_words(words: Sequence[str], others: Sequence[str]) -> int:
    """Letters that differ; MOST + 1 where the words are others, not misspelt."""
    if [word[:1] for word in words] != [other[:1] for other in others]:
        return MOST + 1
    total = 0
    for word, other in zip(words, others, strict=True):
        most = MOST if len(other) >= SHORT else 1
        if word != other:
            if abs(len(word) - len(other)) > most or re.findall(r"\d", word + other):
                return MOST + 1
            wrong = edits(word, other)
            total += wrong if wrong <= most else MOST + 1
    return total


def edits(a: str, b: str) -> int:
    """Letters to insert, to leave out, to replace, or pairs to exchange, that make `b` of `a`.

    >>> edits("TITEL", "TITLE"), edits("SHEL", "SHELL"), edits("ELASTIC", "ELASTIC")
    (1, 1, 0)
    """
    rows = [list(range(len(b) + 1))]
    for i, letter in enumerate(a, 1):
        row = [i]
        for j, other in enumerate(b, 1):
            change = rows[i - 1][j - 1] + (letter != other)
            row.append(min(rows[i - 1][j] + 1, row[j - 1] + 1, change))
            if i > 1 and j > 1 and letter == b[j - 2] and other == a[i - 2]:
                row[j] = min(row[j], rows[i - 2][j - 2] + 1)
        rows.append(row)
    return rows[-1][-1]
