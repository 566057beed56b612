"""The layouts of the data keywords: columns, defaults, and what is refused."""

from collections.abc import Callable

import numpy as np
import pytest

from vmharness.deck import Deck, DeckError, vocabulary
from vmharness.deck.keywords.define.curve import points

Read = Callable[..., Deck]

VOCABULARY = vocabulary("vmharness.deck.keywords")


def widths(name: str) -> list[list[int]]:
    keyword = VOCABULARY[name]
    return [[field.width for field in card.fields.values()] for card in (*keyword.cards, *keyword.rows)]


def test_widths_are_the_formats() -> None:
    assert widths("NODE") == [[8, 16, 16, 16, 8, 8]]
    assert widths("ELEMENT_SHELL") == [[8] * 10]
    assert widths("ELEMENT_SHELL_THICKNESS") == [[8] * 10, [16] * 5]
    assert widths("ELEMENT_MASS") == [[8, 8, 16, 8]]
    assert widths("DEFINE_CURVE") == [[10] * 8, [20, 20]]
    assert widths("PART") == [[70], [10] * 8, [10] * 6, [10] * 6, [10] * 6, [10] * 7]
    eight = [
        name
        for name in VOCABULARY
        if name.startswith(("CONTROL_", "SECTION_", "HOURGLASS", "SET_", "DATABASE_"))
    ]
    for name in set(eight) - {"CONTROL_SOLID"}:  # its second card has ten fields of 8 columns
        for card in widths(name):
            assert all(width == 10 for width in card if width < 70), name
            assert sum(card) <= 80, name


def test_node_and_shell(deck: Read) -> None:
    found = deck(
        "*NODE\n       1            -0.2            -0.2             0.0       7       7\n"
        "       2             0.2            -0.2\n"
        "*ELEMENT_SHELL\n       1       1       1       2       3       4\n"
        "*ELEMENT_SHELL_THICKNESS\n       2       1       1       2       3       4\n             0.1             0.2\n"
    )
    node = found.one("NODE")
    assert node.x.tolist() == [-0.2, 0.2]
    assert node.tc.tolist() == node.rc.tolist() == [7, 0]
    shell = found.one("ELEMENT_SHELL")
    assert np.stack([shell.n1, shell.n2, shell.n3, shell.n4]).ravel().tolist() == [1, 2, 3, 4]
    thick = found.one("ELEMENT_SHELL_THICKNESS")
    assert (thick.thic1.tolist(), thick.thic2.tolist(), thick.thic4.tolist()) == ([0.1], [0.2], [0.0])


def test_parts_and_sections_repeat_with_their_titles(deck: Read) -> None:
    found = deck(
        "*PART\nwall\n1,1,1\nball, of steel\n2,2,2,,4\n"
        "*SECTION_SHELL_TITLE\nthin\n1,2,,3\n0.1\nthick\n2\n0.5,0.5,0.5,0.5\n"
    )
    assert [(p.heading, p.pid, p.hgid) for p in found.all("PART")] == [
        ("wall", 1, 0),
        ("ball, of steel", 2, 4),
    ]
    assert [(s.title, s.secid, s.elform, s.shrf, s.nip, s.t1) for s in found.all("SECTION_SHELL")] == [
        ("thin", 1, 2, 1.0, 3, 0.1),
        ("thick", 2, 2, 1.0, 2, 0.5),
    ]


def test_sets(deck: Read) -> None:
    found = deck(
        "*SET_NODE_TITLE\nsome\n1\n1,2,3,4,5,6,7,8\n9\n*SET_NODE_LIST_GENERATE\n2\n1,4,7,9\n"
        "*SET_NODE_GENERAL\n3\nnode,5,6\nPART,2\n*SET_SEGMENT\n1\n1,2,3,4\n5,6,7,7\n*SET_PART_LIST\n1\n4,5\n"
    )
    assert found.one("SET_NODE_LIST").nodes.tolist() == list(range(1, 10))
    assert found.one("SET_NODE_LIST_GENERATE").ranges.tolist() == [1, 4, 7, 9]
    general = found.one("SET_NODE_GENERAL")
    assert general.option.tolist() == ["NODE", "PART"]
    assert general.e2.tolist() == [6, 0]
    assert found.one("SET_SEGMENT").n4.tolist() == [4, 7]
    assert found.one("SET_PART_LIST").parts.tolist() == [4, 5]
    with pytest.raises(DeckError, match=r"\*SET_NODE_LIST: SID = 2: defined already at deck\.k:3"):
        deck("*SET_NODE_LIST_GENERATE\n2\n1,4\n*SET_NODE_LIST\n2\n1\n")


def test_a_curve_is_scaled_after_its_offset(deck: Read) -> None:
    curve = deck("*DEFINE_CURVE\n1,0,2.0,-3.0,0.5,1.0\n0.0,0.0\n1.0,4.0\n").one("DEFINE_CURVE")
    abscissa, ordinate = points(curve)
    assert abscissa.tolist() == [1.0, 3.0]
    assert ordinate.tolist() == [-3.0, -15.0]
    curve = deck("*DEFINE_CURVE\n1,0,0.0,0.0\n0.,386.\n1.,386.\n").one("DEFINE_CURVE")
    assert points(curve)[1].tolist() == [386.0, 386.0]
    curve = deck("*DEFINE_CURVE\n1\n0.0,0.0\n1.0,1.0\n1.0,2.0\n").one("DEFINE_CURVE")
    with pytest.raises(DeckError, match=r"deck\.k:6: \*DEFINE_CURVE: A1 = 1\.0: abscissae must increase"):
        points(curve)


def test_defaults_of_control_cards(deck: Read) -> None:
    found = deck(
        "*CONTROL_TERMINATION\n0.11\n*CONTROL_TIMESTEP\n\n*CONTROL_CONTACT\n\n\n*CONTROL_SHELL\n\n"
        "*CONTROL_HOURGLASS\n\n*HOURGLASS\n3\n"
    )
    assert found.one("CONTROL_TIMESTEP").tssfac == 0.9
    contact = found.one("CONTROL_CONTACT")
    assert (contact.slsfac, contact.orien, contact.xpene) == (0.1, 1, 4.0)
    assert found.one("CONTROL_SHELL").theory == 2
    assert found.one("CONTROL_HOURGLASS").qh == 0.1
    hourglass = found.one("HOURGLASS")
    assert (hourglass.ihq, hourglass.qm, hourglass.qb, hourglass.qw) == (0, 0.1, 0.1, 0.1)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("*CONTROL_TERMINATION\n\n", "3: *CONTROL_TERMINATION: ENDTIM = (blank): a value is required"),
        ("*CONTROL_CONTACT\n0.1\n", "3: *CONTROL_CONTACT: card 2 is missing (USRSTR, USRFRC, NSBCS, INTERM"),
        ("*CONTROL_HOURGLASS\n\n1.0\n", "4: *CONTROL_HOURGLASS: one line too many"),
        ("*PART\n\n1,1\n", "4: *PART: MID = (blank): a value is required"),
        ("*SET_NODE_LIST\n1\n", "2: *SET_NODE_LIST: no data"),
        ("*SET_NODE_LIST\n1\n0\n", "4: *SET_NODE_LIST: no ids"),
    ],
)  # fmt: skip
def test_what_is_ill_formed_is_refused(deck: Read, content: str, message: str) -> None:
    with pytest.raises(DeckError) as error:
        deck(content)
    assert str(error.value).startswith(f"deck.k:{message}")
