"""What the solver says of the cards of a deck: what it cannot do, and what has no effect."""

from collections.abc import Callable
from pathlib import Path

import pytest

from vmharness.deck import Deck, DeckErrors, read, support, vocabulary
from vmharness.deck.finding import unsupported
from vmharness.explicit.build import build, review
from vmharness.explicit.supported import notes, review_cards, supported

Read = Callable[[str], Deck]

VOCABULARY = vocabulary()


@pytest.fixture
def deck(tmp_path: Path) -> Read:
    """Read a deck from text, whatever the solver makes of it."""

    def from_text(text: str) -> Deck:
        (tmp_path / "deck.k").write_text(text)
        return read(tmp_path / "deck.k", VOCABULARY)

    return from_text


MODEL = """*CONTROL_TERMINATION
1.0
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0
*PART
plate
1,1,1
*SECTION_SHELL
1,2
0.1
*MAT_ELASTIC
1,7800.0,2e11,0.3
*ELEMENT_SHELL
1,1,1,2,3,4
"""  # lines 2 to 18 of a deck


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("*CONTROL_TERMINATION\n0.0\n", "3: *CONTROL_TERMINATION: ENDTIM = 0.0: must be greater than 0"),
        ("*CONTROL_TIMESTEP\n,,3\n", "3: *CONTROL_TIMESTEP: ISDO = 3: only 0, 1 and 2 are supported"),
        (
            "*CONTROL_TIMESTEP\n,,,,,,1\n*CONTROL_TERMINATION\n1.0,,0.1\n",
            "3: *CONTROL_TIMESTEP: ERODE = 1: only 0 is supported",
        ),
        ("*CONTROL_CONTACT\n,,,3\n\n*CONTACT_NODES_TO_SURFACE\n\n\n\n", "3: *CONTROL_CONTACT: SHLTHK = 3: only 0, 1 and 2 are supported"),
        ("*CONTROL_SHELL\n,,,2\n*ELEMENT_SHELL\n1,1,1,2,3,4\n", "3: *CONTROL_SHELL: ISTUPD = 2: only 0 and 1 are supported"),
        ("*PART\n\n1,1,1,2\n", "4: *PART: EOSID = 2: only 0 is supported"),
        ("*SECTION_SHELL\n1\n0.1,,,,0.5\n", "4: *SECTION_SHELL: NLOC = 0.5: only 0.0 is supported"),
        ("*ELEMENT_SHELL\n1,1,1,2,3,4,5\n", "3: *ELEMENT_SHELL: N5 = 5: only 0 is supported"),
        ("*ELEMENT_MASS\n1,5,-0.5\n", "3: *ELEMENT_MASS: MASS = -0.5: must be at least 0"),
        ("*NODE\n1,0.,0.,0.,8\n", "3: *NODE: TC = 8: only 0, 1, 2, 3, 4, 5, 6 and 7 are supported"),
        ("*SET_NODE_GENERAL\n1\nBOX,3\n", "4: *SET_NODE_GENERAL: OPTION = BOX: only ALL, NODE and PART"),
        ("*HOURGLASS\n1,7\n", "3: *HOURGLASS: IHQ = 7: only 0, 1, 2, 3, 4, 5 and 6 are supported"),
        ("*ELEMENT_SHELL\n1,1,1,2,3,4,5\n2,1,1,2,3,4,5\n", "3: *ELEMENT_SHELL: N5 = 5: only 0 is supported (2 such rows)"),
        ("*MAT_ELASTICK\n1\n", "2: *MAT_ELASTICK: unknown keyword; did you mean *MAT_ELASTIC?"),
        ("*MAT_ELASTIC_TITEL\n1\n", "2: *MAT_ELASTIC_TITEL: unknown keyword; did you mean *MAT_ELASTIC_TITLE?"),
        ("*QQQQ\n", "2: *QQQQ: unknown keyword"),
        ("*PART_CONTACT\n\n1,1,1\n0.1\n", "2: *PART_CONTACT: the keyword is not supported"),
    ],
)  # fmt: skip
def test_what_is_not_implemented_is_refused(deck: Read, content: str, message: str) -> None:
    errors = unsupported(support.review(deck("*KEYWORD\n" + content), supported()))
    assert str(errors[0]).startswith(f"deck.k:{message}")
    assert len(errors) == 1


def test_every_known_keyword_is_supported_but_for_those_that_are_not() -> None:
    assert {keyword.name for keyword in VOCABULARY.values()} - supported().keys() == {"PART_CONTACT"}
    assert {support.keyword for support in supported().values()} <= set(VOCABULARY.values())


def test_no_data_keyword_of_the_solver_is_silent_about_having_no_effect() -> None:
    silent = {
        name
        for name, keyword in VOCABULARY.items()
        if name != "PART_CONTACT" and supported()[keyword.name].effect
    }
    assert {name for name in VOCABULARY if name.startswith("DATABASE_")} <= silent
    assert not silent & {
        "NODE",
        "PART",
        "CONTROL_CONTACT",
        "CONTROL_TIMESTEP",
        "CONTROL_TERMINATION",
        "HOURGLASS",
    }


def test_output_requests_are_read_and_said(deck: Read) -> None:
    found = deck(
        "*KEYWORD\n"
        "*DATABASE_NODOUT\n1.0e-4\n*DATABASE_BINARY_D3PLOT\n0.001\n*DATABASE_HISTORY_NODE\n5,6\n"
        "*DATABASE_HISTORY_NODE_ID\n         5the ball, falling\n*DATABASE_EXTENT_BINARY\n\n*CONTROL_ENERGY\n2\n"
    )
    said = notes(review_cards(found), {})
    assert len(said) == 6
    assert said[0] == "*DATABASE_NODOUT: asks for output files; no effect on results."
    assert found.one("DATABASE_HISTORY_NODE_ID").heading.tolist() == ["the ball, falling"]


def test_all_that_is_wrong_stands_in_one_list(deck: Read) -> None:
    """What cards ask for and what the model lacks: each part, each load, each set for itself."""
    text = (
        "*KEYWORD\n"
        + MODEL
        + (
            "*CONTROL_TIMESTEP\n,,3\n"
            "*LOAD_BODY_Z\n7\n"
            "*BOUNDARY_SPC_SET\n9\n"
            "*PART\nno section\n2,5,1\n*PART\nno material\n3,1,6\n"
            "*ELEMENT_SHELL\n2,2,1,2,3,4\n3,3,1,2,3,4\n4,4,1,2,3,4\n"
        )
    )
    with pytest.raises(DeckErrors) as error:
        build(deck(text))
    lines = str(error.value).splitlines()
    assert lines == [
        "deck.k:20: *CONTROL_TIMESTEP: ISDO = 3: only 0, 1 and 2 are supported",
        "deck.k:22: *LOAD_BODY_Z: LCID = 7: no *DEFINE_CURVE with LCID = 7; defined: none",
        "deck.k:24: *BOUNDARY_SPC_SET: NSID = 9: no *SET_NODE_... with SID = 9; defined: none",
        "deck.k:27: *PART: SECID = 5: no *SECTION_SHELL with SECID = 5; defined: 1",
        "deck.k:30: *PART: MID = 6: no *MAT_... with MID = 6; defined: 1",
        "deck.k:34: *ELEMENT_SHELL: PID = 4: no *PART with PID = 4; defined: 1, 2, 3",
    ]


def test_what_follows_from_a_finding_is_none(deck: Read) -> None:
    """The material is that of an unknown keyword; without it the nodes have no mass, which is not said."""
    text = "*KEYWORD\n" + MODEL.replace("*MAT_ELASTIC", "*MAT_FABRIC")
    assert [str(finding) for finding in review(deck(text))] == ["deck.k:15: *MAT_FABRIC: unknown keyword"]


def test_an_option_of_what_the_deck_does_not_have_has_no_effect(deck: Read) -> None:
    text = (
        "*KEYWORD\n"
        + MODEL
        + (
            "*CONTROL_TIMESTEP\n,,,,,,1\n*CONTROL_SOLID\n1\n*LOAD_BODY_PARTS\n1\n*SET_PART\n1\n1\n*TITLE\nplate\n"
        )
    )
    found = review(deck(text))
    assert [str(finding) for finding in found] == [
        "deck.k:20: *CONTROL_TIMESTEP: ERODE = 1: nothing is eroded without DTMIN",
        "deck.k:22: *CONTROL_SOLID: ESORT = 1: no solid is degenerate",
        "deck.k:28: *TITLE: title; no effect on results.",
    ]
    assert all(finding.idle for finding in found)
    build(deck(text))


PLAIN, SINGLE = "*CONTACT_NODES_TO_SURFACE\n1,1,3,3\n\n\n", "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n\n\n\n"


@pytest.mark.parametrize("known", ["", PLAIN, SINGLE, PLAIN + SINGLE])
def test_control_contact_is_reviewed_beside_an_unknown_contact(deck: Read, known: str) -> None:
    control = "*CONTROL_CONTACT\n0.1,,2,1,1\n\n*CONTACT_TIED_NODES_TO_SURFACE_OFFSET\n1,2,4,3\n\n"
    found = [str(finding) for finding in review(deck("*KEYWORD\n" + MODEL + control + known))]
    assert any("*CONTACT_TIED_NODES_TO_SURFACE_OFFSET: unknown keyword" in line for line in found)
    assert any("ISLCHK = 2: initial penetrations are always looked for" in line for line in found)
    ruled = any("every non-automatic contact sets its own SHLTHK, or there is none" in line for line in found)
    assert ruled == (PLAIN not in known)
