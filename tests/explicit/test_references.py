"""Every number that a card names is defined: all that is missing is said at once, also of an ill-formed deck."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from vmharness.deck import Deck, read_all, vocabulary
from vmharness.explicit.build import review
from vmharness.explicit.references.cards import BY_NAME, OTHERS
from vmharness.explicit.supported import review_cards, supported

Read = Callable[[str], Deck]

VOCABULARY = vocabulary()

MODEL = """*KEYWORD
*CONTROL_TERMINATION
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
*DEFINE_CURVE
1
0.0,1.0
1.0,1.0
*SET_NODE
1
1,2
"""  # the next line is the 26th


@pytest.fixture
def deck(tmp_path: Path) -> Read:
    """Read a deck from text, ill-formed or not."""

    def from_text(text: str) -> Deck:
        (tmp_path / "deck.k").write_text(text)
        return read_all(tmp_path / "deck.k", VOCABULARY)[0]

    return from_text


def said(deck: Deck) -> list[str]:
    return [str(finding).partition(": ")[2] for finding in review_cards(deck) if not finding.idle]


FAULTS: dict[str, Any] = {
    "*LOAD_BODY_Z\n7\n": "LCID = 7: no *DEFINE_CURVE with LCID = 7; defined: 1",
    "*LOAD_NODE_POINT\n9,1,1\n": "NID = 9: no *NODE 9",
    "*LOAD_NODE_SET\n5,1,1\n": "NSID = 5: no *SET_NODE_... with SID = 5; defined: 1",
    "*LOAD_SEGMENT\n1,1.0,0.0,1,2,3,9\n": "N4 = 9: no *NODE 9",
    "*LOAD_SEGMENT_SET\n5,1\n": "SSID = 5: no *SET_SEGMENT with SID = 5; defined: none",
    "*LOAD_RIGID_BODY\n5,1,1\n": "PID = 5: no rigid body 5; there are: none",
    "*LOAD_BODY_PARTS\n5\n": "PSID = 5: no *SET_PART_... with SID = 5; defined: none",
    "*CONTROL_TIMESTEP\n,,,,,7\n": "LCTM = 7: no *DEFINE_CURVE with LCID = 7; defined: 1",
    "*BOUNDARY_SPC_NODE\n9,0,1\n": "NID = 9: no *NODE 9",
    "*BOUNDARY_PRESCRIBED_MOTION_SET\n5,1,0,1\n": "NSID = 5: no *SET_NODE_... with SID = 5; defined: 1",
    "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n5,1,0,1\n": "PID = 5: no rigid body 5; there are: none",
    "*CONSTRAINED_EXTRA_NODES_NODE\n5,1\n": "PID = 5: no rigid body 5; there are: none",
    "*CONSTRAINED_NODAL_RIGID_BODY\n8,0,5\n": "NSID = 5: no *SET_NODE_... with SID = 5; defined: 1",
    "*CONSTRAINED_JOINT_SPHERICAL\n1,9\n": "N2 = 9: no *NODE 9",
    "*DAMPING_GLOBAL\n7\n": "LCID = 7: no *DEFINE_CURVE with LCID = 7; defined: 1",
    "*DAMPING_PART_STIFFNESS\n5,0.1\n": "PID = 5: no *PART with PID = 5; defined: 1",
    "*ELEMENT_MASS\n1,9,1.0\n": "NID = 9: no *NODE 9",
    "*ELEMENT_SHELL\n2,5,1,2,3,4\n": "PID = 5: no *PART with PID = 5; defined: 1",
    "*ELEMENT_SHELL\n2,1,1,2,3,9\n": "N4 = 9: no *NODE 9",
    "*DATABASE_HISTORY_NODE\n1,9\n": "IDS = 9: no *NODE 9",
    "*INITIAL_VELOCITY\n5\n1.0\n": "NSID = 5: no *SET_NODE_... with SID = 5; defined: 1",
    "*INITIAL_VELOCITY_NODE\n9,1.0\n": "NID = 9: no *NODE 9",
    "*INITIAL_VELOCITY_GENERATION\n5,2\n\n": "ID = 5: no *PART with PID = 5; defined: 1",
    "*INITIAL_VELOCITY_GENERATION\n5,3\n\n": "ID = 5: no *SET_NODE_... with SID = 5; defined: 1",
    "*MAT_PIECEWISE_LINEAR_PLASTICITY\n2,7800.0,2e11,0.3\n,,7\n\n\n": (
        "LCSS = 7: no *DEFINE_CURVE with LCID = 7; defined: 1"
    ),
    "*RIGIDWALL_PLANAR\n5\n0.0,0.0,-1.0,0.0,0.0,0.0\n": (
        "NSID = 5: no *SET_NODE_... with SID = 5; defined: 1"
    ),
    "*CONTACT_NODES_TO_SURFACE\n5,1,4,3\n\n\n": "SURFA = 5: no *SET_NODE_... with SID = 5; defined: 1",
    "*CONTACT_SURFACE_TO_SURFACE\n1,5,3,0\n\n\n": "SURFB = 5: no *SET_SEGMENT with SID = 5; defined: none",
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n5,0,2\n\n\n": (
        "SURFA = 5: no *SET_PART_... with SID = 5; defined: none"
    ),
    "*PART\nsolid\n2,5,6,0,7\n*ELEMENT_SHELL\n2,2,1,2,3,4\n": [
        "SECID = 5: no *SECTION_SHELL with SECID = 5; defined: 1",
        "MID = 6: no *MAT_... with MID = 6; defined: 1",
        "HGID = 7: no *HOURGLASS with HGID = 7; defined: none",
    ],
    "*SECTION_SOLID\n2,3\n*PART\n\n2,2,1\n": "ELFORM = 3: not implemented; supported: 1 (one point), 2 (fully integrated)",
    "*SECTION_SHELL\n3,16\n0.1\n*PART\n\n3,3,1\n": "ELFORM = 16: not implemented; supported: 2 (Belytschko-Tsay)",
}


@pytest.mark.parametrize("cards", FAULTS)
def test_what_is_not_defined_is_named(deck: Read, cards: str) -> None:
    keyword = cards[: cards.index("\n")]
    expected = [FAULTS[cards]] if isinstance(FAULTS[cards], str) else FAULTS[cards]
    lines = said(deck(MODEL + cards))
    assert lines == [f"{'*PART' if keyword == '*PART' else keyword}: {what}" for what in expected]


@pytest.mark.parametrize("ill_formed", ["", "*CONTROL_HOURGLASS\nx\n"])
def test_all_faults_are_said_at_once(deck: Read, ill_formed: str) -> None:
    """Whatever their number, and whether another card can be read or not; the builder repeats none."""
    left_out = ("ELEMENT_SHELL\n2", "NODAL_RIGID_BODY")  # a second one of a number; a body that others list
    chosen = {cards: what for cards, what in FAULTS.items() if not any(one in cards for one in left_out)}
    found = deck(MODEL + ill_formed + "".join(chosen))
    assert found.sound == (not ill_formed)
    findings = [finding for finding in review(found) if not finding.idle]
    lines = [str(finding).partition(": ")[2].partition("; defined: ")[0] for finding in findings]
    for cards, what in chosen.items():
        assert lines.count(f"{cards.partition(chr(10))[0]}: {what.partition('; defined: ')[0]}") == 1
    places = [(finding.error.line, finding.error.field) for finding in findings]
    assert len(places) == len(set(places))


def test_all_that_is_defined_is_found(deck: Read) -> None:
    good = "*LOAD_NODE_SET\n1,1,1\n*BOUNDARY_SPC_NODE\n1,0,1\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n"
    assert said(deck(MODEL + good)) == []


def test_0_refers_to_nothing_and_so_does_what_is_ill_formed(deck: Read) -> None:
    assert said(deck(MODEL + "*LOAD_BODY_Z\nx\n*RIGIDWALL_PLANAR\n0\n0.,0.,-1.,0.,0.,0.\n*DAMPING_GLOBAL\n0,1.0\n")) == [
        "*LOAD_BODY_Z: LCID = 0: must be greater than 0"  # `vm check` leaves it out: the field is ill-formed
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("cards", "what"),
    [
        ("*SET_NODE\n2\n1,9\n*BOUNDARY_SPC_SET\n2,0,1\n", "*SET_NODE: NODES = 9: no *NODE 9"),
        ("*SET_SEGMENT\n2\n1,2,3,9\n*LOAD_SEGMENT_SET\n2,1\n", "*SET_SEGMENT: N4 = 9: no *NODE 9"),
        (
            "*SET_PART\n2\n1,9\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n2,0,2\n\n\n",
            "*SET_PART: PARTS = 9: no *PART with PID = 9; defined: 1",
        ),
        (
            "*SET_SHELL\n2\n1,9\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n2,0,1\n\n\n",
            "*SET_SHELL: SHELLS = 9: no *ELEMENT_SHELL 9",
        ),
    ],
)
def test_members_of_a_set_that_is_used_are_defined(deck: Read, cards: str, what: str) -> None:
    assert said(deck(MODEL + cards)) == [what]
    assert said(deck(MODEL + cards[: cards.index("*", 1)])) == []


def test_each_number_of_a_column_is_said_once(deck: Read) -> None:
    rows = "*ELEMENT_SHELL\n2,1,1,2,3,6\n3,1,1,2,3,7\n4,1,1,2,3,6\n"
    assert said(deck(MODEL + rows)) == [f"*ELEMENT_SHELL: N4 = {nid}: no *NODE {nid}" for nid in (6, 7)]


def test_of_many_numbers_the_first_are_said_with_the_number_of_the_others(deck: Read) -> None:
    rows = "".join(f"{i},1,1,2,3,{i}\n" for i in range(10, 25))
    lines = said(deck(MODEL + "*ELEMENT_SHELL\n" + rows))
    assert len(lines) == 10
    assert lines[-1] == "*ELEMENT_SHELL: N4 = 19: no *NODE 19 (5 more are missing)"


@pytest.mark.parametrize(
    "part", ["", "*PART\n\n2,3,2\n*MAT_RIGID\n2,7800.0,2e11,0.3\n\n\n*ELEMENT_SHELL\n2,2,1,2,3,4\n"]
)
def test_a_formulation_of_shells_that_are_rigid_or_none_has_no_effect(deck: Read, part: str) -> None:
    found = review_cards(deck(MODEL + "*SECTION_SHELL\n3,16\n0.1\n" + part))
    assert [str(finding) for finding in found] == [
        "deck.k:27: *SECTION_SHELL: ELFORM = 16: no deformable part has this section"
    ]
    assert found[0].idle


def test_a_material_has_a_law_for_the_elements(deck: Read) -> None:
    spring = "*PART\n\n2,1,2\n*MAT_SPRING_ELASTIC\n2,1.0\n*ELEMENT_SHELL\n2,2,1,2,3,4\n"
    (line,) = said(deck(MODEL + spring))
    assert line.startswith(
        "*PART: MID = 2: *MAT_SPRING_ELASTIC has no law for plane stress; these have one: *MAT_"
    )
    beam = (
        "*PART\n\n2,2,2\n*SECTION_BEAM\n2,2\n1.0,1.0,1.0,1.0\n*MAT_PLASTIC_KINEMATIC\n2,7800.0,2e11,0.3,1e9\n\n"
        "*ELEMENT_BEAM\n2,2,1,2,3\n"
    )
    assert said(deck(MODEL + beam)) == ["*PART: MID = 2: resultant beams support *MAT_ELASTIC only"]


def test_what_follows_from_an_unknown_keyword_is_not_said(deck: Read) -> None:
    assert said(deck(MODEL.replace("*DEFINE_CURVE", "*DEFINE_CURVES") + "*LOAD_BODY_Z\n1\n")) == [
        "*DEFINE_CURVES: unknown keyword; did you mean *DEFINE_CURVE?"
    ]


def test_the_tables_name_fields_of_keywords() -> None:
    fields = {
        name: {
            field
            for card in support.keyword.all_cards()
            for field in (*card.defaults(), getattr(card, "flat", ""))
        }
        for name, support in supported().items()
    }
    assert all(fields[keyword] >= set(names) for keyword, names in OTHERS.items())
    assert set().union(*fields.values()) >= set(BY_NAME)


@pytest.mark.parametrize(
    "cards",
    [
        "*ELEMENT_SOLID\n1,1\n",
        "*ELEMENT_SOLID\n1,1\n1,2,3,4,5,6,7,8\n\n1,2\n*SET_NODE\n5\n*SET_SEGMENT\n5\n",
        "*NODE\n*ELEMENT_BEAM\n*SET_PART\n5\n",
        "*CONTACT_NODES_TO_SURFACE\n1\n*CONTACT_TIED_THINGS\n",
    ],
)
def test_cards_that_cannot_be_read_are_passed_over(deck: Read, cards: str) -> None:
    """Also where the effect of another card depends on them."""
    found = deck(MODEL + "*CONTROL_SOLID\n1\n*CONTROL_CONTACT\n0.1,,2\n\n*LOAD_BODY_Z\n7\n" + cards)
    assert not found.sound
    assert "*LOAD_BODY_Z: LCID = 7: no *DEFINE_CURVE with LCID = 7; defined: 1" in said(found)
