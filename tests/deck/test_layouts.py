"""Layouts of LS-DYNA that depend on values, and what real decks have beside data."""

from collections.abc import Callable

import pytest

from vmharness.deck import Deck, DeckError

Read = Callable[..., Deck]


@pytest.mark.parametrize(
    ("elform", "card", "fields"),
    [
        (1, "0.1,0.1,0.2,0.2,1.0,1.0", {"ts1": 0.1, "tt2": 0.2, "nsloc": 1.0}),
        (2, "1.0,2.0,3.0,4.0", {"a": 1.0, "j": 4.0}),
        (3, "1.0,0.5,7.0", {"a": 1.0, "rampt": 0.5, "stress": 7.0}),
        (6, "1.0,2.0,3,4.0,5.0", {"vol": 1.0, "iner": 2.0, "cid": 3, "offset": 5.0}),
        (9, "0.1,0.1,0.0,0.0,1.0", {"ts2": 0.1, "print": 1.0}),
        (13, "1.0,2.0,3.0,4.0", {"itt": 3.0}),
    ],
)
def test_the_second_card_of_a_beam_is_that_of_its_formulation(
    deck: Read, elform: int, card: str, fields: dict[str, float]
) -> None:
    section = deck(f"*SECTION_BEAM\n7,{elform}\n{card}\n").one("SECTION_BEAM")
    assert {name: section.values[name] for name in fields} == fields


def test_material_angles_of_a_shell(deck: Read) -> None:
    found = deck("*SECTION_SHELL\n1,2,1.0,9,,,1\n0.1\n1.,2.,3.,4.,5.,6.,7.,8.\n9.\n2,2\n0.2\n")
    first, second = found.all("SECTION_SHELL")
    assert [first.values[f"b{i}"] for i in range(1, 10)] == [float(i) for i in range(1, 10)]
    assert (second.secid, second.t1) == (2, 0.2)


def test_negative_numbers_that_mean_something_are_well_formed(deck: Read) -> None:
    found = deck(
        "*CONTROL_TIMESTEP\n,,,-1.0,,-5\n*LOAD_BODY_Z\n-3\n*MAT_ELASTIC\n1,1.0,-2.0\nP\n"
        "*CONTACT_NODES_TO_SURFACE\n1,2\n-2.0\n-1.0\n*MAT_RIGID\n2,1.0,1.0,0.3\n-1,5,111011\n\n"
        "*SECTION_SHELL\n1,16,,-1,,-9\n-1.0\n*BOUNDARY_PRESCRIBED_MOTION_SET\n1,-9,4,2\n0.1,0.2\n"
    )
    assert found.one("CONTROL_TIMESTEP").lctm == -5
    assert found.one("CONTACT_NODES_TO_SURFACE").sfsa == -1.0
    assert found.one("MAT_RIGID").con2 == 111011
    assert found.one("BOUNDARY_PRESCRIBED_MOTION_SET").offset2 == 0.2


def test_options_of_names_that_add_no_card_or_the_same(deck: Read) -> None:
    found = deck(
        "*PART_TITLE\nblock\n1,2,3\n*PART_CONTACT\nplate\n2,2,3\n0.1,0.1\n"
        "*CONTACT_AUTOMATIC_SINGLE_SURFACE_TITLE\n5,all of it\n\n\n\n"
    )
    assert (found.one("PART").heading, found.one("PART").pid) == ("block", 1)
    assert found.one("PART_CONTACT").fd == 0.1
    contact = found.one("CONTACT_AUTOMATIC_SINGLE_SURFACE")
    assert (contact.cid, contact.heading) == (5, "all of it")


def test_the_name_of_a_project_stands_under_keyword_id(deck: Read) -> None:
    found = deck("*NODE\n1\n", first="*KEYWORD_ID LONG=S\nproject   run1\n")
    assert found.one("NODE").nid.tolist() == [1]
    with pytest.raises(DeckError, match=r"deck\.k:3: \*KEYWORD_ID: .* may stand only once"):
        deck("*KEYWORD_ID\na\n", first="*KEYWORD\n$\n")


def test_words_in_brackets_after_a_keyword_are_a_comment(deck: Read) -> None:
    found = deck(
        "*ELEMENT_SOLID (ten nodes format)\n       7       1\n"
        + "".join(f"{i:8d}" for i in range(1, 9))
        + "\n"
    )
    assert (found.one("ELEMENT_SOLID").eid.tolist(), found.one("ELEMENT_SOLID").n8.tolist()) == ([7], [8])


def test_what_stands_beyond_column_80_is_no_data(deck: Read) -> None:
    def card(*items: object) -> str:
        return "".join(f"{item:>10}" for item in items).ljust(80)

    found = deck(
        f"*MAT_ELASTIC\n{card(1, 7.8, 2.0, 0.3)} mild steel\n*NODE\n{'       1':80s}here\n*TITLE\n{80 * 't'}beyond\n"
    )
    assert found.one("MAT_ELASTIC").e == 2.0
    assert found.one("NODE").nid.tolist() == [1]
    assert found.title == 80 * "t"
    with pytest.raises(DeckError, match="text beyond the last field, which ends in column 72"):
        deck(f"*NODE\n{'       1':76s}here\n")


def test_zeros_beyond_the_last_field_are_no_data(deck: Read) -> None:
    zeros = 8 * "       0.0"
    found = deck(f"*MAT_RIGID\n1,1.0,1.0,0.3\n{zeros}\n{zeros}\n*CONTROL_TERMINATION\n1.0,0,0,0,0,0,0,0.0\n")
    assert found.one("MAT_RIGID").mid == 1
    with pytest.raises(DeckError, match="more than the 6 items"):
        deck("*CONTROL_TERMINATION\n1.0,0,0,0,0,0,0,0.1\n")


def test_what_a_program_writes_at_the_head_of_a_deck(deck: Read) -> None:
    found = deck(
        "*DATABASE_FORMAT\n0,0\n*CONTROL_SOLUTION\n0\n*CONTROL_SOLID\n1\n*CONTROL_UNITS\nmm,ms,kg\n"
        "*PARAMETER_DUPLICATION\n4\n*DATABASE_BINARY_D3PROP\n2,1\n*DATABASE_TPRINT\n0.001,3\n"
        "*DEFINE_COORDINATE_SYSTEM_TITLE\nglobal\n23,0.,0.,0.,1.\n0.,1.\n*SET_SOLID\n1\n5,6\n"
        "*DATABASE_HISTORY_SOLID_ID\n         1corner block\n*CONTROL_SHELL\n\n\n\n\n\n*CONTROL_TIMESTEP\n\n,,1\n\n"
    )
    assert [entry.spelled for entry in found.entries if entry.raw] == []
    assert found.one("SET_SOLID").solids.tolist() == [5, 6]
    assert found.one("CONTROL_TIMESTEP").imscl == 1
    assert found.one("DATABASE_HISTORY_SOLID_ID").heading.tolist() == ["corner block"]
