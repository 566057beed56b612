"""The resolved deck in long format reads back as the same deck."""

from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.deck import Card, Deck, Rows, read, vocabulary, write_long
from vmharness.deck.field import Field
from vmharness.deck.keyword import Keyword
from vmharness.deck.writer import number

VOCABULARY = vocabulary("vmharness.deck.keywords")

reals = st.floats(allow_nan=False, allow_infinity=False)


@given(reals)
def test_a_real_fits_20_columns_with_all_the_digits_that_fit(value: float) -> None:
    text = number(value)
    assert len(text) <= 20
    if len(repr(value)) <= 20:
        assert float(text) == value
    if abs(value) >= 1e-307:  # below, doubles have fewer digits themselves
        assert abs(float(text) - value) <= 1e-12 * abs(value)
    if 1e-9 <= abs(value) < 1e10:
        assert abs(float(text) - value) <= 1e-14 * abs(value)


def test_the_largest_double_does_not_round_to_infinity() -> None:
    largest = np.finfo(float).max
    assert float(number(float(largest))) == pytest.approx(largest, rel=1e-12)


def item(field: Field) -> st.SearchStrategy[str]:
    """What a comma-separated card may have for a field."""
    if field.unused:
        return st.sampled_from(["", "0", "0.0"])
    if field.kind == "text":
        letters = st.characters(codec="utf-8", exclude_categories=("C", "Z"), exclude_characters=",&$*")
        least = 1 if field.default is None else 0
        return st.text(letters, min_size=least, max_size=10 if field.width < 70 else 60)
    low = field.above
    if field.kind == "integer":
        return st.integers(1 if low is not None else -(10**9), 10**9).map(str)
    return reals.map(lambda value: abs(value) or 1.0 if low is not None else value).map(repr)


def card_line(card: Card) -> st.SearchStrategy[str]:
    if isinstance(card, Rows) and card.flat:
        return (
            st.lists(st.integers(1, 10**9).map(str), min_size=1, max_size=8).map(",".join).map("{},".format)
        )
    return st.tuples(*map(item, card.fields.values())).map(",".join)


@st.composite
def card_lines(draw: st.DrawFn, keyword: Keyword) -> list[str]:
    """A line for each card that is there, given the values on the cards before it."""
    lines, entry = [], SimpleNamespace()
    for card in (*keyword.cards, *keyword.rows):
        if card.when and not card.when(entry):
            continue
        lines.append(draw(card_line(card)))
        if not isinstance(card, Rows):
            items = zip(card.fields.items(), lines[-1].split(","), strict=True)
            vars(entry).update((name, field.read(written, {})) for (name, field), written in items)
    return lines


blocks = st.sampled_from(sorted(VOCABULARY)).flatmap(
    lambda name: card_lines(VOCABULARY[name]).map(lambda lines: "\n".join([f"*{name}", *lines]))
)


def parse(text: str) -> Deck:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "deck.k"
        path.write_text(text, encoding="utf-8", newline="")
        return read(path, VOCABULARY)


def equal(a: Any, b: Any) -> bool:
    if isinstance(a, np.ndarray) and a.dtype.kind == "f":
        return bool(np.all(np.abs(a - b) <= 1e-12 * np.abs(a) + 1e-319))
    if isinstance(a, np.ndarray):
        return bool(np.array_equal(a, b))
    if isinstance(a, float):
        return abs(a - b) <= 1e-12 * abs(a) + 1e-319
    return bool(a == b)


@given(blocks)
def test_any_entry_reads_back_equal(block: str) -> None:
    deck = parse(f"*KEYWORD\n{block}\n")
    text = write_long(deck)
    again = parse(text)
    (before,), (after,) = deck.entries, again.entries
    assert before.keyword is after.keyword
    assert before.values.keys() == after.values.keys()
    for name, value in before.values.items():
        assert equal(value, after.values[name]), name
    assert write_long(again) == text  # rounding happens once


@pytest.mark.parametrize(
    "block",
    [
        "*SECTION_BEAM\n1,2\n1.0,2.0,3.0,4.0",
        "*SECTION_BEAM\n1,3\n1.0",
        "*PART_INERTIA\nlocal axes\n1,2,3\n1.0,2.0,3.0,4.0,1\n1.0,,,2.0,,3.0\n\n1.0,,,,1.0",
        "*PART_INERTIA\nglobal axes\n1,2,3\n,,,4.0,0,7\n1.0,0.1,0.2,2.0,0.3,3.0\n1.0,,,2.0",
        "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA_TITLE\nbody\n1\n,,,4.0,1\n1.0,,,2.0,,3.0\n\n1.0,,,,1.0",
    ],
)
def test_cards_that_depend_on_a_value_or_a_suffix_read_back(block: str) -> None:
    deck = parse(f"*KEYWORD\n{block}\n")
    again = parse(write_long(deck))
    (before,), (after,) = deck.entries, again.entries
    assert before.values == after.values
    assert before.lines.keys() == after.lines.keys()


@pytest.mark.parametrize("heading", ["$ no comment", "*NO_KEYWORD", "a, b, c", "x" * 70, ""])
def test_headings_stay_headings(heading: str) -> None:
    deck = parse(f"*KEYWORD\n*PART\n {heading[:69]}\n1,1,1\n*TITLE\n {heading}\n")
    again = parse(write_long(deck))
    assert again.one("PART").heading == heading[:69]
    assert again.title == heading


def test_includes_are_flat_and_parameters_are_values(tmp_path: Path) -> None:
    (tmp_path / "nodes.k").write_text("*NODE\n       1              &a\n")
    (tmp_path / "deck.k").write_text(
        "*KEYWORD\n*PARAMETER\nR a,0.1\n*PARAMETER_EXPRESSION\nR third,&a/3\n*INCLUDE\nnodes.k\n"
        "*SET_NODE_LIST_TITLE\nall\n1\n1\n*CONTROL_CONTACT\n&third\n\n\n\n"
    )
    text = write_long(read(tmp_path / "deck.k", VOCABULARY, {"a": 0.7}))
    assert "PARAMETER" not in text
    assert "INCLUDE" not in text
    assert "&" not in text
    assert text.splitlines()[0] == "*KEYWORD LONG=Y"
    again = parse(text)
    assert again.one("NODE").x.tolist() == [0.7]
    assert again.one("SET_NODE_LIST").title == "all"
    assert again.one("CONTROL_CONTACT").slsfac == pytest.approx(0.7 / 3, rel=1e-15)
    assert len(text.split("*CONTROL_CONTACT\n")[1].split("*END")[0].splitlines()) == 2  # no optional card


def test_a_card_that_is_not_there_is_not_written(tmp_path: Path) -> None:
    """Trusses and beams have one field A, each on a card of its own."""
    deck = tmp_path / "deck.k"
    deck.write_text("*KEYWORD\n*SECTION_BEAM\n1,2\n1.0,2.0,3.0,4.0\n2,3\n5.0\n*END\n")
    long = tmp_path / "long.k"
    long.write_text(write_long(read(deck, VOCABULARY)))
    beam, truss = read(long, VOCABULARY).all("SECTION_BEAM")
    assert (beam.secid, beam.a, beam.iss, beam.itt, beam.j) == (1, 1.0, 2.0, 3.0, 4.0)
    assert (truss.secid, truss.a) == (2, 5.0)
