"""What a solver declares to support of the cards, and a deck reviewed by it."""

from collections.abc import Callable

import pytest

from vmharness.deck import Card, Deck, Keyword, integer, real, text, vocabulary
from vmharness.deck.misspelling import misspelling_of
from vmharness.deck.rule import above, among, anything, at_least, between, no_effect, only, unless
from vmharness.deck.support import Supported, by_name, effects, review, supports, without_effect

Read = Callable[..., Deck]

SHELL = Keyword(
    "SHELL", Card(elform=integer(2), label=text("A", capitals=True), t=real(1.0), output=integer(0))
)
TABLE = Keyword("TABLE", Card(i=integer(width=8, above=0), x=real(0.0, width=16)), table=True)
BOX = Keyword("BOX", Card(id=integer()))
OTHER = Keyword("OTHER", Card(id=integer()))
KNOWN = {keyword.name: keyword for keyword in (SHELL, TABLE, BOX, OTHER)}


def said(deck: Deck, supported: Supported) -> list[tuple[str, bool]]:
    return [(str(finding).removeprefix("deck.k:"), finding.idle) for finding in review(deck, supported)]


def test_a_value_that_is_not_supported_is_named_with_those_that_are(deck: Read) -> None:
    supported = by_name([supports(SHELL, elform=among(2, 16), label=among("A", "B"), t=above(0.0))])
    found = deck("*SHELL\n17,c,0.0\n*SHELL\n16,b\n", known=KNOWN)
    assert said(found, supported) == [
        ("3: *SHELL: ELFORM = 17: only 2 and 16 are supported", False),
        ("3: *SHELL: LABEL = C: only A and B are supported", False),
        ("3: *SHELL: T = 0.0: must be greater than 0", False),
    ]


def test_of_a_table_the_first_row_is_named_with_their_number(deck: Read) -> None:
    found = deck("*TABLE\n1,0.0\n2,2.0\n3,1.0\n4,3.0\n", known=KNOWN)
    assert said(found, by_name([supports(TABLE, x=among(0.0, 1.0))])) == [
        ("4: *TABLE: X = 2.0: only 0.0 and 1.0 are supported (2 such rows)", False)
    ]
    assert said(found, by_name([supports(TABLE, x=only(0.0))])) == [
        ("4: *TABLE: X = 2.0: only 0.0 is supported (3 such rows)", False)
    ]
    assert said(found, by_name([supports(TABLE, x=between(-1.0, 3.0))])) == [
        ("6: *TABLE: X = 3.0: must lie between -1 and 3", False)
    ]
    assert said(found, by_name([supports(TABLE, x=at_least(0.0))])) == []


def test_what_is_not_the_default_may_have_no_effect(deck: Read) -> None:
    """A value that is not supported, too, where what it acts on is missing."""
    idle = unless(lambda deck: deck.all(BOX), "the deck has no boxes")
    supported = by_name([
        supports(SHELL, idle, elform=only(2), t=anything(lambda deck, entry: ""), output=no_effect("of output")),
        without_effect(BOX, "a box; no effect."),
    ])  # fmt: skip
    assert said(deck("*SHELL\n16,,2.0,1\n*SHELL\n2\n", known=KNOWN), supported) == [
        ("3: *SHELL: ELFORM = 16: the deck has no boxes", True),
        ("3: *SHELL: OUTPUT = 1: of output", True),
    ]
    with_boxes = deck("*SHELL\n16,,2.0,1\n*BOX\n1\n*BOX\n2\n", known=KNOWN)
    assert said(with_boxes, supported) == [
        ("3: *SHELL: ELFORM = 16: only 2 is supported", False),
        ("3: *SHELL: OUTPUT = 1: of output", True),
        ("4: *BOX: a box; no effect.", True),
    ]
    assert effects(with_boxes, supported) == ["*BOX: a box; no effect."]


def test_keywords_that_are_not_declared_are_not_supported(deck: Read) -> None:
    supported = by_name([supports(SHELL), supports(TABLE)])
    found = deck("*OTHER\n1\n*SHEL\n2\n*QQQQ\n", known=KNOWN)
    assert said(found, supported) == [
        ("2: *OTHER: the keyword is not supported", False),
        ("4: *SHEL: unknown keyword; did you mean *SHELL?", False),
        ("6: *QQQQ: unknown keyword", False),
    ]


def test_a_declaration_that_cannot_be_meant_is_refused() -> None:
    with pytest.raises(ValueError, match=r"\*SHELL has no field nip"):
        supports(SHELL, nip=only(2))
    with pytest.raises(ValueError, match=r"what is supported of \*SHELL is declared twice"):
        by_name([supports(SHELL), supports(SHELL)])


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("MAT_ELASTIK", "MAT_ELASTIC"),
        ("MAT_ELASITC_TITLE", "MAT_ELASTIC_TITLE"),
        ("CONTROL_TERMINATON", "CONTROL_TERMINATION"),
        ("SET_NODE_LIST_GENERAT", "SET_NODE_LIST_GENERATE"),
        ("BOUNDRY_SPC_SET", "BOUNDARY_SPC_SET"),
        *(
            (name, "")
            for name in ("MAT_VISCOELASTIC", "MAT_SPRING_INELASTIC", "MAT_027", "MAT_ELASTIC_FLUID")
        ),
        *(
            (name, "")
            for name in ("SET_TSHELL", "ELEMENT_TSHELL", "SECTION_TSHELL", "LOAD_BODY_V", "MAT_ORTHOTROPIC")
        ),
        *(
            (name, "")
            for name in ("DEFINE_TABLE", "MAT_SPRING_MAXWELL", "ELEMENT_SEATBELT", "RIGIDWALL_GEOMETRIC", "")
        ),
    ],
)
def test_only_a_probable_typing_error_is_corrected(name: str, meant: str) -> None:
    known = {other for keyword in vocabulary().values() for other in keyword.names()} - {name}
    assert misspelling_of(name, known) == meant
