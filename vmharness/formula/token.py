"""Tokens of a formula: numbers, names and signs."""

import re
from dataclasses import dataclass

from vmharness.formula.error import FormulaError

MAX_CHARACTERS, MAX_TOKENS = 2000, 400

_TOKEN = re.compile(
    r"[ \t\r\n]*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)"
    r"|(?P<name>[A-Za-z][A-Za-z0-9_]*)|(?P<sign>\*\*|<=|>=|==|!=|[-+*/^<>(),])|(?P<end>$))"
)


@dataclass(frozen=True)
class Token:
    """A number, a name, a sign or the end (kind "end", no text), and the column where it begins."""

    kind: str
    text: str
    column: int


def tokens(text: str) -> list[Token]:
    """The words of `text`, the end last; `^` is read as `**`.

    >>> [token.text for token in tokens("2*h^2")]
    ['2', '*', 'h', '**', '2', '']
    """
    if len(text) > MAX_CHARACTERS:
        raise FormulaError(f"`{text[:40]}...`: longer than {MAX_CHARACTERS} characters; name its parts")
    found: list[Token] = []
    at = 0
    while not found or found[-1].kind != "end":
        match = _TOKEN.match(text, at)
        if not match or not match.lastgroup:
            column = len(text) - len(text[at:].lstrip())
            hint = "; write == to compare" if text[column] == "=" else ""
            raise error(text, column + 1, f"`{text[column]}` is not allowed in a formula{hint}")
        word = match[match.lastgroup]
        found.append(Token(match.lastgroup, "**" if word == "^" else word, match.start(match.lastgroup) + 1))
        at = match.end()
        if len(found) > MAX_TOKENS:
            raise FormulaError(
                f"`{text[:40]}...`: more than {MAX_TOKENS} numbers, names and signs; name its parts"
            )
    return found


def error(text: str, column: int, what: str) -> FormulaError:
    """FormulaError with the formula and the column (from 1)."""
    return FormulaError(f"`{text}`, column {column}: {what}")
