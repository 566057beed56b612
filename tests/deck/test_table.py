"""The quick way through a table gives what the careful way gives, or steps aside."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.deck import Card, DeckError, integer, real
from vmharness.deck.block import Block
from vmharness.deck.error import refuse
from vmharness.deck.table import careful_columns, fast_columns

CARD = Card(
    i=integer(width=8, above=0),
    x=real(0.25, width=16, zero_is_default=True),
    y=real(0.0, width=16),
    c=integer(0, width=8),
)

items = st.one_of(
    st.sampled_from(
        [
            "",
            "1",
            "7",
            "0",
            "-3",
            "3.",
            "2.5",
            ".5",
            "1e2",
            "1.0+2",
            "1d1",
            "1e999",
            "inf",
            "1_0",
            "&p",
            "x",
            "0x1",
        ]
    ),
    st.integers(1, 99999).map(str),
    st.floats(-1e9, 1e9).map(lambda value: f"{value:.9g}"),
)
fixed = st.tuples(items, items, items, items).map(
    lambda row: f"{row[0]:>8s}{row[1]:>16s}{row[2]:>16s}{row[3]:<8s}"
)
lines = st.lists(
    st.one_of(fixed, st.just(""), st.just("1,2.0"), st.just(" " * 48 + "9")), min_size=1, max_size=6
)


@given(lines)
def test_quick_and_careful_agree(texts: list[str]) -> None:
    block = Block("T", "", "deck.k", 1, False, texts, list(range(2, 2 + len(texts))))
    quick = fast_columns(CARD, texts, long=False)
    wrong: list[DeckError] = []
    try:
        careful = careful_columns(CARD, block, range(len(texts)), {"p": 1}, wrong)
        refuse(wrong)
    except DeckError:
        assert quick is None
        return
    if quick is not None:
        for a, b in zip(quick, careful, strict=True):
            assert a.dtype == b.dtype
            np.testing.assert_array_equal(a, b)


@given(st.lists(st.tuples(st.integers(1, 10**7), st.floats(-1e99, 1e99)), min_size=1, max_size=20))
def test_plain_tables_take_the_quick_way(rows: list[tuple[int, float]]) -> None:
    texts = [f"{i:8d}{x:16.8e}" for i, x in rows]
    quick = fast_columns(CARD, texts, long=False)
    assert quick is not None
    assert quick[0].tolist() == [i for i, _ in rows]
    assert quick[1].tolist() == [float(f"{x:.8e}") or 0.25 for _, x in rows]
    assert quick[3].tolist() == [0] * len(rows)


@pytest.mark.parametrize("item", ["1e999", "1.0+2", "1d1", "&p", "nan", "x"])
def test_what_needs_care_is_left_to_the_careful_way(item: str) -> None:
    assert fast_columns(CARD, [f"{1:8d}{1.0:16f}", f"{2:8d}{item:>16s}"], long=False) is None
