"""Blocks of keywords that the reader does not know, kept as they stand."""

from collections.abc import Callable

import pytest

from vmharness.deck import Deck, DeckError, write_long

Read = Callable[..., Deck]

FABRIC = """*MAT_FABRIC
$ a comment is no data
         7    7.8E-6     210.0

  words, with a comma\tand a tab
"""


def test_an_unknown_keyword_keeps_its_lines_and_its_place(deck: Read) -> None:
    found = deck(f"*TITLE\na\n{FABRIC}*SET_PART\n1\n2\n")
    assert [entry.spelled for entry in found.entries] == ["TITLE", "MAT_FABRIC", "SET_PART"]
    (fabric,) = found.all("MAT_FABRIC")
    assert fabric.raw is not None
    assert (fabric.line, fabric.values) == (4, {})
    assert fabric.raw.lines == [
        "         7    7.8E-6     210.0", "", "  words, with a comma\tand a tab",
    ]  # fmt: skip
    assert fabric.raw.numbers == [6, 7, 8]
    assert str(fabric.error(None, "not here")) == "deck.k:4: *MAT_FABRIC: not here"


def test_a_written_deck_keeps_them_in_their_own_format(deck: Read) -> None:
    """What is written is long, but for lines that are not understood."""
    wide = f"{1:20d}{2.5:20f}"
    text = write_long(deck(f"*SET_PART\n1\n2\n{FABRIC}*MAT_NEW+\n{wide}\n"))
    assert text.splitlines() == [
        "*KEYWORD LONG=Y",
        "*SET_PART",
        f"{1:20d}" + "".join(f"{0.0:20}" for _ in range(4)) + f"{'MECH':20s}".rstrip(),
        f"{2:20d}",
        "*MAT_FABRIC-",
        "         7    7.8E-6     210.0",
        "",
        "  words, with a comma\tand a tab",
        "*MAT_NEW",
        wide,
        "*END",
    ]
    again = deck(text.removeprefix("*KEYWORD LONG=Y\n"), "*KEYWORD LONG=Y\n")
    assert write_long(again) == text
    assert [entry.raw.long for entry in again.entries if entry.raw] == [False, True]


def test_parameters_of_their_lines_stay_defined(deck: Read) -> None:
    content = (
        "*PARAMETER\nR rho,7.8e-6,I  n,3\nC word,steel\nR other,1.0\n*PARAMETER_EXPRESSION\nR twice,2*&rho\n"
        "*MAT_FABRIC\n         &n      &RHO   -&twice\n &word\n*SET_PART\n&n\n2\n"
    )
    text = write_long(deck(content, parameters={"rho": 1.5}))
    assert text.splitlines()[:6] == [
        "*KEYWORD LONG=Y",
        "*PARAMETER",
        "I n,3",
        "R rho,1.5",
        "R twice,3.0",
        "C word,steel",
    ]
    again = deck(text.removeprefix("*KEYWORD LONG=Y\n"), "*KEYWORD LONG=Y\n")
    assert again.parameters == {"n": 3, "rho": 1.5, "twice": 3.0, "word": "steel"}
    assert again.one("SET_PART").sid == 3


def test_words_are_kept(deck: Read) -> None:
    found = deck("*COMMENT\nany words, of any length" + 90 * "." + "\n\nand &more\n*TITLE\na\n")
    assert write_long(found).splitlines()[1:5] == [
        "*COMMENT-", "any words, of any length" + 90 * ".", "", "and &more",
    ]  # fmt: skip


def test_a_tab_is_no_error_but_where_lines_are_read(deck: Read) -> None:
    with pytest.raises(DeckError, match=r"deck\.k:4: \*SET_PART: a tab in a data line"):
        deck("*SET_PART\n1\n2\t3\n")
