"""Formats: fixed, comma, long, blank lines, comments, line ends, options."""

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.deck import (
    Card,
    Deck,
    DeckError,
    Keyword,
    Rows,
    integer,
    read,
    real,
    skip,
    text,
    vocabulary,
)

Read = Callable[..., Deck]

TWO = Keyword("TWO", Card(a=integer(), b=real(0.5)), Card(c=real(0.0), d=text("x")))
GROUPS = Keyword("GROUPS", Card(heading=text("", width=70)), Card(id=integer(0)), repeat=True)
TABLE = Keyword("TABLE", Card(i=integer(width=8), x=real(0.0, width=16), n=integer(0, width=8)), table=True)
LATER = Keyword(
    "LATER",
    Card(n=integer(0)),
    Card(when=lambda entry: entry.n > 0, e=real(7.0)),
    Card(optional=True, p=real(1.0)),
    Card(optional=True, q=real(2.0)),
    options={"ID": Card(cid=integer(0), heading=text("", width=70))},
)
IDS = Keyword("IDS", Card(sid=integer()), Rows(per_line=8, ids=integer(0)), options=("TITLE",))
VOCABULARY = vocabulary("vmharness.deck.keywords")
KNOWN = {keyword.name: keyword for keyword in (TWO, GROUPS, TABLE, LATER, IDS)}


def test_fixed_comma_and_long_lines_give_the_same(deck: Read) -> None:
    fixed = "*TWO\n         1       2.5\n      -3.0         y\n"
    comma = "*TWO\n1,2.5\n -3.0 , y,\n"
    mixed = "*TWO\n1,2.5\n      -3.0         y\n"
    long = f"*TWO+\n{1:20d}{2.5:20f}\n{-3.0:20f}{'y':>20s}\n"
    spaced = long.replace("*TWO+", "*two +  ")
    whole = long.replace("TWO+", "TWO")
    expected = {"a": 1, "b": 2.5, "c": -3.0, "d": "y"}
    for content in (fixed, comma, mixed, long, spaced):
        assert deck(content, known=KNOWN).one("TWO").values == expected
    for first in ("*KEYWORD LONG=Y\n", "*keyword long=k\n"):
        assert deck(whole, first, KNOWN).one("TWO").values == expected
    standard = fixed.replace("*TWO", "*TWO-")
    assert deck(standard, "*KEYWORD LONG=Y\n", KNOWN).one("TWO").values == expected
    assert deck(fixed, "*KEYWORD LONG=S MEMORY=100M\n", KNOWN).notes == [
        "*KEYWORD: MEMORY=100M cannot change results."
    ]


def test_fields_may_touch_each_other(deck: Read) -> None:
    entry = deck(
        "*TABLE\n       1 2.1000000000E11       7\n      12-2.1000000000E-1-1234567\n", known=KNOWN
    ).one("TABLE")
    assert entry.i.tolist() == [1, 12]
    assert entry.x.tolist() == [2.1e11, -0.21]
    assert entry.n.tolist() == [7, -1234567]


def test_comments_stand_anywhere_and_(deck: Read) -> None:
    content = "$ before\n*KEYWORD\n*TWO\n$ between\n1\n$\n$ \u00b5\n\n"
    assert deck(content, first="", known=KNOWN).one("TWO").values == {"a": 1, "b": 0.5, "c": 0.0, "d": "x"}


def test_bytes_of_any_encoding_in_headings(tmp_path: Path) -> None:
    path = tmp_path / "latin.k"
    path.write_bytes(b"\xef\xbb\xbf*KEYWORD\n*GROUPS\nStahl \xc3\xa4\n1\n")
    assert read(path, KNOWN).one("GROUPS").heading == "Stahl ä"
    path.write_bytes(b"$ \xb5m \x81\n*KEYWORD\n*GROUPS\nStahl \xe4\n1\n")
    assert read(path, KNOWN).one("GROUPS").heading == "Stahl ä"


def test_line_ends_of_windows(deck: Read) -> None:
    content = "*KEYWORD\r\n*TWO\r\n         1\r\n\r\n*TABLE\r\n       3             1.5\r\n*END\r\n"
    found = deck(content, first="", known=KNOWN)
    assert (found.one("TWO").a, found.one("TWO").d, found.one("TABLE").x.tolist()) == (1, "x", [1.5])


def test_end_stops_reading(deck: Read) -> None:
    assert deck("*TWO\n1\n\n*END\nnonsense\n*NONSENSE\n", known=KNOWN).one("TWO").a == 1


def test_a_blank_line_is_a_card_of_defaults_but_begins_nothing(deck: Read) -> None:
    two = deck("*TWO\n1\n\n\n\n", known=KNOWN).all("TWO")
    assert [entry.values for entry in two] == [{"a": 1, "b": 0.5, "c": 0.0, "d": "x"}]
    groups = deck("*GROUPS\n\n1\nsecond\n2\n\n\n*GROUPS\nthird\n\n\n", known=KNOWN).all("GROUPS")
    assert [(entry.heading, entry.id) for entry in groups] == [("", 1), ("second", 2), ("third", 0)]
    assert deck("*TABLE\n1,2.0\n2,3.0\n\n\n", known=KNOWN).one("TABLE").x.tolist() == [2.0, 3.0]


def test_a_blank_line_within_a_table_is_refused(deck: Read) -> None:
    for rows in ("       1             2.0\n\n       2\n", "1,2.0\n\n2,\n"):
        with pytest.raises(DeckError, match=r"deck.k:4: \*TABLE: a blank line among the rows"):
            deck("*TABLE\n" + rows, known=KNOWN)
    with pytest.raises(DeckError, match=r"deck.k:5: \*DEFINE_CURVE: a blank line among the rows"):
        deck(f"*DEFINE_CURVE\n1\n{0.0:20f}{2.0:20f}\n\n{1.0:20f}{2.0:20f}\n")


def test_conditional_and_optional_cards(deck: Read) -> None:
    def values(content: str) -> tuple[int, float, float, float]:
        entry = deck(content, known=KNOWN).one("LATER")
        return entry.n, entry.e, entry.p, entry.q

    assert values("*LATER\n0\n") == (0, 7.0, 1.0, 2.0)
    assert values("*LATER\n0\n3.\n") == (0, 7.0, 3.0, 2.0)
    assert values("*LATER\n1\n5.\n3.\n4.\n") == (1, 5.0, 3.0, 4.0)
    assert values("*LATER\n1\n\n\n4.\n") == (1, 7.0, 1.0, 4.0)


def test_options_put_a_card_before_the_group(deck: Read) -> None:
    entry = deck("*LATER_ID\n         9wall, and floor\n0\n", known=KNOWN).one("LATER")
    assert (entry.cid, entry.heading, entry.spelled, entry.keyword) == (
        9,
        "wall, and floor",
        "LATER_ID",
        LATER,
    )
    entry = deck("*LATER_ID\n9,wall, and floor\n0\n", known=KNOWN).one("LATER")
    assert (entry.cid, entry.heading) == (9, "wall, and floor")
    entry = deck("*LATER\n0\n", known=KNOWN).one("LATER")
    assert (entry.cid, entry.heading) == (0, "")


def test_ids_are_one_list_without_blanks_and_zeros(deck: Read) -> None:
    entry = deck("*IDS_TITLE\nall\n5\n1,2,,4\n         0         7\n         8\n", known=KNOWN).one("IDS")
    assert entry.title == "all"
    assert entry.ids.tolist() == [1, 2, 4, 7, 8]
    assert [entry.line_of("ids", row) for row in range(5)] == [5, 5, 5, 6, 7]


def test_rows_of_several_cards(deck: Read) -> None:
    pair = Keyword("PAIR", Card(i=integer()), Card(x=real(0.0), y=real(1.0)), table=True)
    entry = deck("*PAIR\n1\n2.,3.\n2\n4.\n", known={"PAIR": pair}).one("PAIR")
    assert (entry.i.tolist(), entry.x.tolist(), entry.y.tolist()) == ([1, 2], [2.0, 4.0], [3.0, 1.0])
    assert entry.line_of("y", 1) == 6
    with pytest.raises(DeckError, match=r"deck.k:5: \*PAIR: a row takes 2 lines"):
        deck("*PAIR\n1\n2.\n3\n", known={"PAIR": pair})


def test_zero_means_the_default_where_the_field_says_so(deck: Read) -> None:
    keyword = Keyword("Z", Card(sf=real(0.9, zero_is_default=True), n=integer(2, zero_is_default=True)))
    rows = Keyword("R", Card(sf=real(0.9, zero_is_default=True)), table=True)
    for content in ("*Z\n0.0,0\n", "*Z\n\n", "*Z\n,2\n", "*Z\n0,0.0\n"):
        assert deck(content, known={"Z": keyword}).one("Z").values == {"sf": 0.9, "n": 2}
    found = deck("*R\n       0.0\n       0.5\n", known={"R": rows}).one("R")
    assert found.sf.tolist() == [0.9, 0.5]


def test_unused_columns_are_blank_or_zero(deck: Read) -> None:
    keyword = Keyword("U", Card(a=integer(), _2=skip(), b=integer(0)))
    assert deck("*U\n         1                   3\n", known={"U": keyword}).one("U").values == {
        "a": 1,
        "b": 3,
    }
    assert deck("*U\n1,0,3\n", known={"U": keyword}).one("U").b == 3
    with pytest.raises(DeckError, match=r"UNUSED = 5: only 0.0 is supported"):
        deck("*U\n1,5,3\n", known={"U": keyword})


def test_arrays_have_the_type_of_their_field(deck: Read) -> None:
    for row in ("       1             2.0", "1,2.0", "       1           1.0+5"):
        entry = deck(f"*TABLE\n{row}\n", known=KNOWN).one("TABLE")
        assert (entry.i.dtype, entry.x.dtype, entry.n.dtype) == (np.int64, np.float64, np.int64)


KEYWORDS = (
    "*NODE *PART *SET_NODE_LIST_TITLE *DEFINE_CURVE *CONTROL_CONTACT+ *TITLE *PARAMETER *INCLUDE *END *"
)
DATA = [
    "$",
    "",
    "1,2,3",
    "1,&a",
    "R a,1.0",
    "R b,a**a",
    "       1       2",
    "&a",
    "+",
    "*PARAMETER_EXPRESSION",
]
pieces = st.sampled_from([*KEYWORDS.split(), *DATA])


@given(st.lists(pieces | st.text(max_size=30), max_size=12))
def test_any_text_is_a_deck_or_an_error_with_its_line(lines: list[str]) -> None:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "deck.k"
        path.write_bytes("\n".join(["*KEYWORD", *lines]).encode("utf-8", "replace"))
        try:
            found = read(path, VOCABULARY)
        except DeckError as error:
            assert str(error).startswith(f"deck.k:{error.line}: ")  # noqa: PT017
            assert 1 < error.line <= len(lines) + 1  # noqa: PT017
        else:
            assert all(1 < entry.line <= len(lines) + 1 for entry in found.entries)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-32-le"])
def test_a_wide_encoding_is_named(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "deck.k"
    path.write_bytes("*KEYWORD\n*NODE\n1,0.0\n".encode(encoding))
    with pytest.raises(
        DeckError, match=r"deck.k:1: is written in UTF-16 or UTF-32; save it as ASCII or UTF-8"
    ):
        read(path, VOCABULARY)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"*KEYWORD\r*NODE\r1,0.0\r", r"deck.k:1: a line ends in CR alone; convert line ends to LF or CR LF"),
        (b"*KEYWORD\n*NODE\r1,0.0\n", r"deck.k:2: a line ends in CR alone"),
    ],
)
def test_what_is_no_text_is_named(tmp_path: Path, content: bytes, message: str) -> None:
    path = tmp_path / "deck.k"
    path.write_bytes(content)
    with pytest.raises(DeckError, match=message):
        read(path, VOCABULARY)


@pytest.mark.parametrize(
    "content", [b"\xef\xbb\xbf*KEYWORD\r\n*NODE\r\n1,0.0\r\n", b"*KEYWORD\r\r\n*NODE\r\r\n1,0.0\r"]
)
def test_other_line_ends_and_marks_are_read(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "deck.k"
    path.write_bytes(content)
    assert read(path, VOCABULARY).one("NODE").nid.tolist() == [1]
