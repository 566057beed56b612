"""Lookups: what is found, and how an error names the card that asks."""

from collections.abc import Callable

import pytest

from vmharness.deck import Card, Deck, DeckError, Keyword, integer, text

Read = Callable[..., Deck]

ELASTIC = Keyword("MAT_ELASTIC", Card(mid=integer()), aliases=("MAT_001",), unique="mid", repeat=True)
RIGID = Keyword("MAT_RIGID", Card(mid=integer()), unique="mid")
NODES = Keyword("NODE", Card(nid=integer(width=8)), table=True, unique="nid", kind="node")
PART = Keyword("PART", Card(pid=integer(), mid=integer()), repeat=True, unique="pid")
NAME = Keyword("TITLE", Card(title=text("", width=80)))
KNOWN = {k.name: k for k in (ELASTIC, RIGID, NODES, PART, NAME)} | {"MAT_001": ELASTIC}

CONTENT = "*MAT_001\n1\n2\n*MAT_RIGID\n5\n*PART\n10,5\n20,3\n*TITLE\n  ball and wall  \n*TITLE\nx\n"


def test_all_in_file_order_by_keyword_name_or_alias(deck: Read) -> None:
    found = deck(CONTENT, known=KNOWN)
    for asked in (ELASTIC, "MAT_ELASTIC", "mat_001", "*MAT_001"):
        assert [entry.mid for entry in found.all(asked)] == [1, 2]
    assert [entry.mid for entry in found.all(RIGID, ELASTIC)] == [5, 1, 2]
    assert found.all("LOAD_BODY_Z") == []
    assert [entry.spelled for entry in found.entries][:4] == ["MAT_001", "MAT_001", "MAT_RIGID", "PART"]


def test_find_names_the_card_that_asks(deck: Read) -> None:
    found = deck(CONTENT, known=KNOWN)
    first, second = found.all(PART)
    assert found.find(ELASTIC, RIGID, mid=first.mid, referred_by=(first, "mid")).keyword is RIGID
    with pytest.raises(DeckError) as error:
        found.find(ELASTIC, RIGID, mid=second.mid, referred_by=(second, "mid"))
    assert str(error.value) == "deck.k:9: *PART: MID = 3: no *MAT_... with MID = 3; defined: 1, 2, 5"
    with pytest.raises(DeckError, match=r"^deck\.k: no \*PART with PID = 7; defined: 10, 20$"):
        found.find(PART, pid=7)
    with pytest.raises(DeckError, match=r"defined: none"):
        found.find("DEFINE_CURVE", lcid=7)


def test_one_and_first(deck: Read) -> None:
    found = deck(CONTENT, known=KNOWN)
    assert found.one(RIGID).mid == 5
    assert found.first("CONTROL_SHELL") is None
    with pytest.raises(DeckError, match=r"^deck\.k: \*CONTROL_TERMINATION is required$"):
        found.one("CONTROL_TERMINATION")
    with pytest.raises(
        DeckError, match=r"^deck\.k:9: .*may stand only once; there is one already at deck\.k:8$|^deck"
    ):
        found.one(PART)


def test_title(deck: Read) -> None:
    found = deck("*TITLE\n  ball and wall  \n", known=KNOWN)
    assert found.title == "ball and wall"
    assert deck("*NODE\n1\n", known=KNOWN).title == ""


def test_an_id_is_defined_once_over_tables_and_cards(deck: Read) -> None:
    with pytest.raises(DeckError) as error:
        deck("*NODE\n1\n2\n3\n*NODE\n4\n3\n2\n", known=KNOWN)
    assert str(error.value) == "deck.k:8: *NODE: NID = 3: defined already at deck.k:5"
    assert len(deck("*PART\n0,1\n0,2\n", known=KNOWN).all(PART)) == 2  # 0 is no id
    with pytest.raises(DeckError) as error:
        deck("*PART\n1,1\n1,2\n", known=KNOWN)
    assert str(error.value) == "deck.k:4: *PART: PID = 1: defined already at deck.k:3"
