"""Damaged decks: whatever is wrong is said with its place, and what can be read is written back the same."""

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from vmharness.backends.builtin import review
from vmharness.deck import Deck, DeckError, Entry, read, vocabulary, write_long
from vmharness.deck.reader import read_all

CASES = Path(__file__).parents[2] / "cases"
LONGEST = 20_000  # characters of a deck: small ones show as much, and more of them
TEXTS = [text for path in sorted(CASES.glob("*/deck.k")) if len(text := path.read_text("utf-8")) <= LONGEST]
KEYWORDS = sorted(vocabulary())
OPTIONS = ["_TITLE", "_ID", "_MPP", "_SET", "_GENERATE", "+", "-", " (words)", " words", "_", " +"]
NUMBERS = [
    *(
        "0",
        "-1",
        "1",
        "2",
        "3",
        "7",
        "8",
        "99999999",
        "-2147483648",
        "1.5",
        "-0.0",
        "0.0",
        "1e-300",
        "1e300",
        "-1e300",
    ),
    *("5e-324", "1.0d3", "1+5", "0.5", "-0.5", "1e-9", "1e9", ""),
]
OTHERS = [
    *(
        "9223372036854775807",
        "9" * 20,
        "1e999",
        "nan",
        "inf",
        "-inf",
        "0x10",
        "1_0",
        "1e",
        ".",
        "-",
        "+",
        "1,2,3",
    ),
    *("&", "&x", "-&x", "abc", "*", "$", "\t", "\0", "ü", "١", "\u2028", "1 2", '"', "%"),
]
ENCODINGS = [*["utf-8"] * 12, "utf-8-sig", "latin-1", "utf-16", "utf-16-le", "cp1252"]
LINE_ENDS = [*["\n"] * 12, "\r\n", "\r", "\r\r\n"]

Damage = tuple[
    str, float, float, Any
]  # what is done, at which share of the lines and of the line, and with what
share = st.integers(0, 9999).map(lambda number: number / 10000)
numbers = st.tuples(st.just("value"), share, share, st.sampled_from(NUMBERS))
anything = st.tuples(
    st.sampled_from(["delete", "double", "swap", "value", "insert", "option", "keyword", "cut"]),
    share,
    share,
    st.sampled_from(NUMBERS) | st.sampled_from(OTHERS) | st.sampled_from(KEYWORDS) | st.sampled_from(OPTIONS),
)
damages = st.lists(numbers, min_size=1, max_size=3) | st.lists(anything | numbers, min_size=1, max_size=4)


def damaged(text: str, what: list[Damage]) -> str:
    """The text after each damage in turn."""
    lines = text.split("\n")
    for kind, share, place, value in what:
        at = min(int(share * len(lines)), len(lines) - 1)
        keywords = [i for i, line in enumerate(lines) if line.startswith("*")] or [at]
        if kind == "delete" and len(lines) > 1:
            del lines[at]
        elif kind == "double":
            lines.insert(at, lines[at])
        elif kind == "swap":
            lines[at], lines[-1 - at] = lines[-1 - at], lines[at]
        elif kind == "value":
            lines[at] = with_value(lines[at], place, value)
        elif kind == "insert":
            lines.insert(at, value)
        elif kind == "cut":
            lines[at:] = [lines[at][: int(place * len(lines[at]))]]
        else:
            at = keywords[min(int(share * len(keywords)), len(keywords) - 1)]
            lines[at] = lines[at] + value if kind == "option" else f"*{value}"
    return "\n".join(lines)


def with_value(line: str, place: float, value: str) -> str:
    """The line with another value in one of its fields."""
    if "," in line:
        items = line.split(",")
        items[min(int(place * len(items)), len(items) - 1)] = value
        return ",".join(items)
    start = 10 * int(place * 7)
    return line[:start].ljust(start) + value.rjust(10) + line[start + 10 :]


def errors_of(deck: Deck, errors: list[DeckError]) -> Iterator[DeckError]:
    """What reading and the review of the solver find wrong."""
    for error in errors:
        yield from error.errors
    for finding in review(deck, {}):
        yield from finding.error.errors


def same(one: Entry, other: Entry) -> bool:
    """Whether two entries have the same keyword and values, but for the last digits of reals."""
    if one.raw is not None and other.raw is not None:
        return one.spelled == other.spelled and one.raw.lines == other.raw.lines
    return one.spelled == other.spelled and all(
        np.shape(value) == np.shape(other.values[name]) and np.all(close(value, other.values[name]))
        for name, value in one.values.items()
    )


def close(one: Any, other: Any) -> Any:
    if np.asarray(one).dtype.kind == "f":
        return np.abs(np.asarray(one) - other) <= 1e-12 * np.abs(one) + 1e-319
    return np.asarray(one) == np.asarray(other)


@pytest.fixture(scope="module", autouse=True)
def quiet() -> Iterator[None]:
    """Hostile numbers overflow; that is no matter of this test."""
    with np.errstate(all="ignore"):
        yield


@settings(max_examples=250, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large])
@given(st.sampled_from(TEXTS), damages, st.sampled_from(ENCODINGS), st.sampled_from(LINE_ENDS))
def test_a_damaged_deck_is_read_or_said_with_its_place(
    text: str, what: list[Damage], encoding: str, line_end: str
) -> None:
    content = damaged(text, what).replace("\n", line_end).encode(encoding, "replace")
    with TemporaryDirectory() as folder:
        path = Path(folder) / "deck.k"
        path.write_bytes(content)
        deck, errors = read_all(path, vocabulary())
        for error in errors_of(deck, errors):
            assert error.file == "deck.k", error
            assert error.line >= 1 or error.what.endswith(" is required"), error
            assert error.what
        if deck.sound:
            path.write_text(write_long(deck), encoding="utf-8", newline="")
            again = read(path, vocabulary())
            assert len(again.entries) == len(deck.entries)
            assert all(map(same, deck.entries, again.entries))
