"""Cards of contacts: what is read, and what is refused by name."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.contact.cards import control_of, number_of, options_of

NAMES = [
    "NODES_TO_SURFACE",
    "ONE_WAY_SURFACE_TO_SURFACE",
    "SURFACE_TO_SURFACE",
    "AUTOMATIC_NODES_TO_SURFACE",
    "AUTOMATIC_SURFACE_TO_SURFACE",
    "AUTOMATIC_SINGLE_SURFACE",
]
FULL = """*CONTACT_NODES_TO_SURFACE_ID
         7a contact
         8         1         4         3
       0.4       0.3       2.0       5.0      20.0         0       0.1       0.9
       1.0       1.0       0.0       0.0       0.0       0.0       0.5       3.0
         1       0.2
       0.0         0         0         1
         1         2
"""


def options(deck):
    (entry,) = deck.all("CONTACT_NODES_TO_SURFACE")
    return options_of(entry, control_of(deck))


def test_every_option_arrives(bodies):
    found = options(bodies(FULL))
    assert (found.fs, found.fd, found.dc, found.vc, found.vdc) == (0.2, 0.15, 2.0, 15.0, 20.0)
    assert (found.bt, found.dt, found.soft, found.sofscl, found.ignore) == (0.1, 0.9, 1, 0.2, True)


def test_defaults_are_a_frictionless_penalty_for_all_time(bodies):
    found = options(bodies("*CONTACT_NODES_TO_SURFACE\n8,1,4,3\n\n\n"))
    assert (found.fs, found.fd, found.vc, found.vdc) == (0.0, 0.0, np.inf, 0.0)
    assert (found.bt, found.dt, found.soft, found.ignore) == (0.0, 1e20, 0, False)


def test_control_contact_says_what_becomes_of_initial_penetrations_unless_the_contact_does(bodies):
    everywhere = "*CONTROL_CONTACT\n\n\n\n1\n"
    assert options(bodies("*CONTACT_NODES_TO_SURFACE\n8,1,4,3\n\n\n" + everywhere)).ignore


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    ("cards", "message"),
    [
        ("1,0,3,0,5\n\n\n", "SABOXID = 5: only 0 is supported"),
        ("1,0,3\n-1.0\n\n", "FS = -1.0: must be at least 0"),
        ("1,0,3\n,,,,-5.0\n\n", "VDC = -5.0: must be at least 0"),
        ("1,0,3\n,,,,,3\n\n", "PENCHK = 3: only .*0.* supported"),
        ("1,0,3\n\n-1.0\n", "SFSA = -1.0: must be greater than 0"),
        ("1,0,3\n\n\n2\n", "SOFT = 2: only 0 and 1 are supported"),
        ("1,0,3\n\n\n,,7\n", "LCIDAB = 7: only 0 is supported"),
        ("1,0,3\n\n\n\n,1\n", "THKOPT = 1: only 0 is supported"),
        ("1,0,3\n\n\n\n,,,,,,0.1\n", "SLDTHK = 0.1: only 0.0 is supported"),
        ("1,0,3\n\n\n\n\n,,0.1\n", "DPRFAC = 0.1: only 0.0 is supported"),
        ("1,0,3\n\n\n\n\n\n1\n", "Q2TRI = 1: only 0 is supported"),
        ("1,0,3\n\n\n\n\n\n\n1\n", "SHAREC = 1: only 0 is supported"),
        ("1,0,3\n\n\n\n\n\n\n\n1\n", "PSTIFF = 1: only 0 is supported"),
        ("1,0,3\n\n\n\n\n\n\n\n\n,0.5\n", "SHLOFF = 0.5: only 0.0 is supported"),
    ],
)
def test_options_that_are_not_supported_name_field_and_value(bodies, name, cards, message):
    with pytest.raises(DeckError, match=rf"deck.k:\d+: \*CONTACT_{name}: {message}"):
        bodies(f"*CONTACT_{name}\n{cards}")


def test_a_node_set_can_only_be_tracked(bodies):
    for name in NAMES:
        able = name.endswith("NODES_TO_SURFACE")
        if able:
            bodies(f"*CONTACT_{name}\n8,1,4,3\n\n\n")
            continue
        with pytest.raises(DeckError, match="SURFATYP = 4: only"):
            bodies(f"*CONTACT_{name}\n8,1,4,3\n\n\n")


def test_fs_2_is_a_table_not_a_coefficient(bodies):
    with pytest.raises(DeckError, match=r"FS = 2.0: stands for a table"):
        options(bodies("*CONTACT_NODES_TO_SURFACE\n8,1,4,3\n2.0\n\n"))


def test_a_contact_does_not_end_before_its_birth(bodies):
    with pytest.raises(DeckError, match=r"DT = 0.5: the contact would end before its birth at 0.5"):
        options(bodies("*CONTACT_NODES_TO_SURFACE\n8,1,4,3\n,,,,,,0.5,0.5\n\n"))


def test_contacts_are_numbered_through_all_keywords_in_the_order_of_the_deck(bodies):
    cards = "8,1,4,3\n\n\n"
    deck = bodies(
        f"*CONTACT_NODES_TO_SURFACE\n{cards}*CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID\n77\n{cards}"
        f"*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n{cards}"
    )
    contacts = [entry for entry in deck.entries if entry.keyword.name.startswith("CONTACT_")]
    assert [number_of(deck, entry) for entry in contacts] == [1, 77, 3]
    twice = bodies(f"*CONTACT_NODES_TO_SURFACE_ID\n2\n{cards}*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n{cards}")
    with pytest.raises(DeckError, match="another contact has this number"):
        number_of(twice, twice.one("CONTACT_NODES_TO_SURFACE"))
