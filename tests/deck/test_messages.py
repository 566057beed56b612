"""Every error says file, line, keyword, field, value, and what would be right; all are found in one reading."""

import pickle
from collections.abc import Callable
from pathlib import Path

import pytest

from vmharness.deck import Card, Deck, DeckError, DeckErrors, Keyword, integer, read, real, skip, text

Read = Callable[..., Deck]

MAT = Keyword(
    "MAT_ELASTIC",
    Card(mid=integer(above=0), ro=real(above=0.0), e=real(), pr=real(0.0), _da=skip()),
    aliases=("MAT_001",),
    options=("TITLE",),
    unique="mid",
)
MAT2 = Keyword("MAT_RIGID", Card(mid=integer(above=0), ro=real(above=0.0)), unique="mid")
SHELL = Keyword("SHELL", Card(elform=integer(2), label=text("A")))
TABLE = Keyword("TABLE", Card(i=integer(width=8, above=0), x=real(0.0, width=16)), table=True)
CONTROL = Keyword("CONTROL", Card(x=real(0.0)), single=True)
KNOWN = {k.name: k for k in (MAT, MAT2, SHELL, TABLE, CONTROL)} | {"MAT_001": MAT}


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("*\n", "2: unknown keyword"),
        ("*SHELL 5\n", "2: *SHELL: unexpected text after the keyword: 5"),
        ("*KEYWORD\n", "2: *KEYWORD: *KEYWORD may stand only once, at the beginning of a file"),
        ("*SHELL\n\n*MAT_001\n$\n1,1.,x\n", "6: *MAT_001: E = x: not a number"),
        ("*MAT_ELASTIC\n1.5,1.,1.\n", "3: *MAT_ELASTIC: MID = 1.5: not an integer"),
        ("*MAT_ELASTIC\n,1.,1.\n", "3: *MAT_ELASTIC: MID = (blank): a value is required"),
        ("*MAT_ELASTIC\n0,1.,1.\n", "3: *MAT_ELASTIC: MID = 0: must be greater than 0"),
        ("*MAT_ELASTIC\n1,1.,1.,,0.5\n", "3: *MAT_ELASTIC: UNUSED = 0.5: only 0.0 is supported"),
        ("*MAT_ELASTIC\n1,&q,1.\n", "3: *MAT_ELASTIC: RO = &q: undefined parameter"),
        ("*SHELL\n2,A,5\n", "3: *SHELL: more than the 2 items of this card"),
        ("*SHELL\n         2         A      5\n", "3: *SHELL: text beyond the last field, which ends in column 20"),
        ("*SHELL\n         2\n\n         3\n", "5: *SHELL: one line too many: this keyword has one line here"),
        ("*SHELL\n", "2: *SHELL: card 1 is missing (ELFORM, LABEL)"),
        ("*SHELL\n\t2\n", "3: *SHELL: a tab in a data line hides its columns; write blanks or commas"),
        ("*TABLE\n", "2: *TABLE: no data"),
        ("*TABLE\n       1\n      -2\n", "4: *TABLE: I = -2: must be greater than 0"),
        ("*TABLE\n       1\n       2             1.0       9\n", "4: *TABLE: text beyond the last field"),
        ("*TABLE\n1\n2,1e999\n", "4: *TABLE: X = 1e999: too large for double precision"),
        ("*TABLE\n       1           1e999\n", "3: *TABLE: X = 1e999: too large for double precision"),
        ("*TABLE+\n99999999999999999999\n", "3: *TABLE: I = 99999999999999999999: too large for an integer"),
        ("*CONTROL\n\n*CONTROL\n\n", "4: *CONTROL: may stand only once; there is one already at deck.k:2"),
        ("*MAT_ELASTIC\n7,1.,1.\n*MAT_RIGID\n7,1.\n", "5: *MAT_RIGID: MID = 7: defined already at deck.k:3"),
    ],
)  # fmt: skip
def test_message(deck: Read, content: str, message: str) -> None:
    with pytest.raises(DeckError) as error:
        deck(content, known=KNOWN)
    assert str(error.value).startswith(f"deck.k:{message}")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "deck.k:1: a deck begins with *KEYWORD; only comments may come before"),
        ("$ only comments\n", "deck.k:1: a deck begins with *KEYWORD; only comments may come before"),
        ("$\n*SHELL\n", "deck.k:2: *SHELL: a deck begins with *KEYWORD; only comments may come before"),
        ("$\n  1\n*KEYWORD\n", "deck.k:2: data before the first keyword"),
        ("*KEYWORD\n1.0\n", "deck.k:2: *KEYWORD: *KEYWORD has no data lines"),
        ("*KEYWORD I10=Y\n", "deck.k:1: *KEYWORD: I10 = Y: only N supported"),
        (
            "*KEYWORD SPEED=1\n",
            "deck.k:1: *KEYWORD: unknown option SPEED=1; supported: LONG, I10, MEMORY, MEMORY2, NCPU, JOBID, PROJECT, NUM, STAGE",
        ),
    ],
)
def test_how_a_deck_begins(deck: Read, content: str, message: str) -> None:
    with pytest.raises(DeckError) as error:
        deck(content, first="", known=KNOWN)
    assert str(error.value) == message


def test_no_such_deck(tmp_path: Path) -> None:
    with pytest.raises(DeckError, match=r"^none\.k: no such file$"):
        read(tmp_path / "none.k", KNOWN)


def test_errors_of_callers_name_the_field_and_its_line(deck: Read) -> None:
    found = deck("*SHELL\n        16\n*TABLE\n1\n2,1.0\n", known=KNOWN)
    shell, table = found.one("SHELL"), found.one("TABLE")
    assert str(shell.error("elform", "only 2 here")) == "deck.k:3: *SHELL: ELFORM = 16: only 2 here"
    assert str(shell.error(None, "not here")) == "deck.k:2: *SHELL: not here"
    assert str(table.error("x", "too much", row=1)) == "deck.k:6: *TABLE: X = 1.0: too much"
    with pytest.raises(AttributeError, match=r"\*SHELL has no field thickness"):
        _ = shell.thickness


def test_an_error_survives_a_pickle() -> None:
    error = DeckError("wrong", "deck.k", 3, "NODE", "x", 1.0)
    assert str(pickle.loads(pickle.dumps(error))) == str(error) == "deck.k:3: *NODE: X = 1.0: wrong"


def test_all_that_is_ill_formed_is_found_in_one_reading(deck: Read) -> None:
    content = (
        "*MAT_ELASTIC\n0,1.,x\n*SHELL 5\n\n*PARAMETER\nR a\n*MAT_RIGID\n&a,&b\n*TABLE\n1,x\n2,y\n3,1.0,7,9\n"
        "*INCLUDE\nnone.k\n*CONTROL\n\n1\n*CONTROL\n\n"
    )
    with pytest.raises(DeckErrors) as error:
        deck(content, known=KNOWN)
    assert str(error.value).splitlines() == [
        "deck.k:4: *SHELL: unexpected text after the keyword: 5",
        "deck.k:3: *MAT_ELASTIC: MID = 0: must be greater than 0",
        "deck.k:3: *MAT_ELASTIC: E = x: not a number",
        "deck.k:7: *PARAMETER: VAL1 = (blank): parameter a: a value is required",
        "deck.k:9: *MAT_RIGID: RO = &b: undefined parameter",
        "deck.k:11: *TABLE: X = x: not a number (2 such rows)",
        "deck.k:13: *TABLE: more than the 2 items of this card",
        "deck.k:15: *INCLUDE: FILENAME = none.k: no such file in the deck's folder",
        "deck.k:18: *CONTROL: one line too many: this keyword has one line here",
        "deck.k:19: *CONTROL: may stand only once; there is one already at deck.k:16",
    ]
    assert str(pickle.loads(pickle.dumps(error.value))) == str(error.value)
    assert (error.value.line, error.value.keyword) == (4, "SHELL")
    assert len(error.value.errors) == 10
