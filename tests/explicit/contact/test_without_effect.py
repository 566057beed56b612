"""What the cards of a contact say in vain is said in the facts of the run; what would change physics is refused."""

import pytest

from vmharness.deck import DeckError
from vmharness.explicit.build import build

PLAIN, AUTOMATIC = "CONTACT_NODES_TO_SURFACE", "CONTACT_AUTOMATIC_NODES_TO_SURFACE"
TWO_WAY, SINGLE = "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", "CONTACT_AUTOMATIC_SINGLE_SURFACE"


def fact(bodies, keyword, one="", two="", three="", optional="", more="", name="contact 1"):
    """What is said to be without effect in a contact of the bodies."""
    sides = {TWO_WAY: "1,2,3,3", SINGLE: "1,0,3,0"}.get(keyword, "8,1,4,3")
    if keyword in (PLAIN, AUTOMATIC):
        more += "*ELEMENT_MASS\n1,31,1.0\n"
    text = f"*{keyword}\n{one or sides}\n{two}\n{three}\n{optional}"
    return build(bodies(text + more)).facts.get(f"Without effect in {name}", "")


@pytest.mark.parametrize("keyword", [PLAIN, AUTOMATIC, TWO_WAY, SINGLE])
def test_defaults_written_out_are_not_said(bodies, keyword):
    given = dict(two="0.0,0.0,0.0,0.0,0.0,0,0.0,1e20", three="1.0,1.0,0.0,0.0,1.0,1.0,1.0,1.0")
    cards = "0,0.1,0,1.025,2,2,0,1\n0.0,0,0,0\n1,0\n"
    assert fact(bodies, keyword, **given, optional=cards) == ""
    assert fact(bodies, keyword, optional="0,0.0,0,0.0,0,0,0,0\n\n0\n") == ""


@pytest.mark.parametrize(
    ("keyword", "cards", "said"),
    [
        (PLAIN, dict(optional=",,,,,,10\n"), "BSORT = 10 (the search interval follows from the nodal velocities)"),
        (PLAIN, dict(optional=",0.2,,,3,5\n"), "SBOPT = 3 (act with SOFT = 2); DEPTH = 5 (act with SOFT = 2); "
         "SOFSCL = 0.2 (acts with SOFT = 1)"),
        (PLAIN, dict(optional="1,0.2\n"), ""),
        (PLAIN, dict(one="8,1,4,3,0,0,1,1"), "SAPR = 1 (affects output only); SBPR = 1 (affects output only)"),
        (PLAIN, dict(optional="\n\n2,,,,,,,4\n"), "CID_RCF = 4 (affects output only); IGAP = 2 (acts in implicit analysis only)"),
        (PLAIN, dict(three=",,0.1,0.1,2.0"), "SAST = 0.1 (SHLTHK = 0: no thickness counts); "
         "SFSAT = 2.0 (SHLTHK = 0: no thickness counts); SBST = 0.1 (SHLTHK = 0: no thickness counts)"),
        (PLAIN, dict(three=",,0.1,0.1", optional="\n,,1\n"), ""),
        (AUTOMATIC, dict(three=",,,0.1,,2.0"), "SFSBT = 2.0 (SBST is used instead)"),
        (AUTOMATIC, dict(optional="\n,,1\n"), "SHLTHK = 1 (thickness always counts)"),
        (PLAIN, dict(two=",,,,,2", optional="\n0.1\n"), "PENMAX = 0.1 (PENCHK is used instead)"),
        (PLAIN, dict(two="0.3,0.2"), "FD = 0.2 (DC = 0 keeps friction at FS)"),
        (PLAIN, dict(two="0.3,0.2,1.0"), ""),
        (PLAIN, dict(two="0.3,0.3,1.0"), "DC = 1.0 (FS = FD)"),
        (PLAIN, dict(two=",,,5.0", three=",,,,,,0.5,2.0"), "VC = 5.0 (no friction); FSF = 0.5 (no friction); "
         "VSF = 2.0 (no friction)"),
        (PLAIN, dict(two="0.3,0.3", three=",,,,,,0.5,2.0"), "VSF = 2.0 (VC = 0)"),
        (PLAIN, dict(three="3.0", more="*CONTROL_CONTACT\n,,,,2\n\n"), "SFSA = 3.0 (PENOPT = 2: the stiffness is that "
         "of the segments)"),
        (TWO_WAY, dict(three="3.0", more="*CONTROL_CONTACT\n,,,,2\n\n"), ""),
        (SINGLE, dict(one="4,0,5,0"), "SURFA = 4 (SURFATYP = 5 means all parts; the number is not used)"),
    ],
)  # fmt: skip
def test_a_field_that_does_not_act_is_said_with_its_reason(bodies, keyword, cards, said):
    assert fact(bodies, keyword, **cards) == said


@pytest.mark.parametrize(
    ("cards", "keyword", "said"),
    [
        (",,1,,,,1\n\n", PLAIN, ""),
        ("\n,,50\n", PLAIN, "NSBCS = 50 (the search interval follows from the nodal velocities)"),
        (",1.0,2\n\n", PLAIN, "ISLCHK = 2 (initial penetrations are always looked for); "
         "RWPNAL = 1.0 (acts on rigid bodies at rigid walls)"),
        ("\n,,,,2.0,1,1,1\n", PLAIN, "ECDT = 1 (acts on eroding contacts); TIEDPRJ = 1 (acts on tied contacts); "
         "XPENE = 2.0 (acts with PENCHK = 1); SSTHK = 1 (acts on single surfaces)"),
        ("\n,,,,,1\n", SINGLE, ""),
        (",,,1,,,2\n\n", AUTOMATIC, "ORIEN = 2 (acts on contacts that are not automatic); "
         "SHLTHK = 1 (every non-automatic contact sets its own SHLTHK, or there is none)"),
        ("\n\n\n,1,1,1\n,,0\n,,,,1\n", PLAIN, "FRCENG = 1 (the energy of friction is always kept); "
         "SKIPRWG = 1 (affects output only); OUTSEG = 1 (affects output only); FTALL = 1 (affects output only); "
         "RWGAPS = 0 (acts in implicit analysis only)"),
    ],
)  # fmt: skip
def test_so_it_is_for_control_contact(bodies, cards, keyword, said):
    assert fact(bodies, keyword, more=f"*CONTROL_CONTACT\n{cards}", name="*CONTROL_CONTACT") == said


def test_a_deck_without_contact_has_none_that_it_scales(bodies):
    facts = build(bodies("*CONTROL_CONTACT\n0.2,,,,2\n\n\n1\n")).facts
    assert facts["Without effect in *CONTROL_CONTACT"] == (
        "SLSFAC = 0.2 (no contact); PENOPT = 2 (no contact); IGNORE = 1 (every contact sets its own IGNORE)"
    )


@pytest.mark.parametrize(
    ("keyword", "optional", "said"),
    [
        (PLAIN, "", False),
        (PLAIN, "\n,,,1\n", True),
        (PLAIN, "\n,,1\n", True),
        (AUTOMATIC, "", True),
        (SINGLE, "", True),
    ],
)
def test_nodes_that_shoot_through_are_not_moved_back_whatever_snlog(bodies, keyword, optional, said):
    sides = "1,0,3" if keyword == SINGLE else "8,1,4,3"
    mass = "" if keyword == SINGLE else "*ELEMENT_MASS\n1,31,1.0\n"
    facts = build(bodies(f"*{keyword}\n{sides}\n\n\n{optional}{mass}")).facts
    assert ("not moved back" in facts.get("Shooting nodes of contact 1", "")) == said


@pytest.mark.parametrize(
    ("one", "three", "message"),
    [
        ("1,2,3", "", "SURFB = 2"),
        ("1,0,3", ",2.0", "SFSB = 2.0"),
        ("1,0,3", ",,,0.2", "SBST = 0.2"),
        ("1,0,3", ",,,,,2.0", "SFSBT = 2.0"),
    ],
)
def test_a_single_surface_has_nothing_on_side_b(bodies, one, three, message):
    with pytest.raises(
        DeckError, match=rf"deck.k:\d+: \*{SINGLE}: {message}: a single surface has no second side"
    ):
        build(bodies(f"*{SINGLE}\n{one}\n\n{three}\n"))
