"""From the deck: orientation by a node or by a vector, several parts, and what is refused."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

DECK = """*KEYWORD
*CONTROL_TERMINATION
1e-4
*PART
beam
1,1,{material}
*SECTION_BEAM_TITLE
rectangle
1,2,0.8333,2.0,1.0
{section}
*MAT_ELASTIC
1,7850.0,2.1E11,0.3
*NODE
1,0.0,0.0,0.0,7,7
2,1.0,0.0,0.0
3,0.3,0.0,0.7,7
4,0.3,0.0,0.0,7
*ELEMENT_BEAM{element}
"""
SECTION = "2e-4,4e-9,1e-9,4e-9,1.5e-4"


def model(deck, element="\n1,1,1,2,3", section=SECTION, material=1, more=""):
    return build(deck(DECK.format(element=element, section=section, material=material) + more))


@pytest.mark.parametrize("element", ["\n1,1,1,2,3", "_ORIENTATION\n1,1,1,2\n-5.0,0.0,0.2"])
def test_s_lies_in_the_plane_of_the_axis_and_the_third_node(deck, element):
    """s is z, so that a push along z bends about t, with I_tt: 12 EI/L^3 when the end does not turn, less by shear."""
    m = model(deck, element)
    m.state.x[1] += [0.0, 1e-6, 1e-6]
    m.forces[0].add(m.state)
    g = 2.1e11 / 2.6
    for name, moment in (("s-shear", 1e-9), ("t-shear", 4e-9)):
        phi = 12 * 2.1e11 * moment / (g * 1.5e-4)
        shear = probe(m, beam=1, component=name)()
        assert abs(shear) == pytest.approx(12 * 2.1e11 * moment / (1 + phi) * 1e-6, rel=1e-6)


def test_beams_and_trusses_in_one_deck(deck):
    """One keyword, two sections: each element belongs to the force of its formulation."""
    more = "2,2,2,4\n*PART\ntruss\n2,2,1\n*SECTION_BEAM\n2,3\n1e-4\n"
    m = model(deck, more=more)
    assert {force.name for force in m.forces} == {"beams of part 1", "trusses of part 2"}
    assert m.state.mass[3] == pytest.approx(7850.0 * 1e-4 * 0.7 / 2)
    assert m.state.mass[1] == pytest.approx(7850.0 * (2e-4 / 2 + 1e-4 * 0.7 / 2))
    assert m.state.mass[2] == 0.0  # the third node only shows a direction
    m.state.v[1, 0] = 1.0
    *_, s = steps(m)
    assert np.isfinite(s.x).all()
    pull = [probe(m, beam=eid, component="axial-stress")() for eid in (1, 2)]
    assert pull[0] / pull[1] == pytest.approx(0.7, rel=1e-3)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"section": "2e-4,0.0,1e-9,4e-9"}, "ISS = 0.0: must be greater than 0"),
        ({"section": "2e-4,1e-9"}, "ITT.*a value is required"),
        ({"section": "2e-4,4e-9,1e-9,4e-9,0.0,1.0"}, "IST = 1.0: only 0.0 is supported"),
        ({"element": "\n1,1,1,2"}, "N3 = 0: a beam needs a third node, or a vector, that lies off its axis"),
        (
            {"element": "\n1,1,1,2,4"},
            "N3 = 4: a beam needs a third node, or a vector, that lies off its axis",
        ),
        ({"element": "\n1,1,1,2,8"}, "N3 = 8: no .NODE 8"),
        ({"element": "\n1,1,1,2,3,0,0,0,2"}, "RR2 = 2: only 0 is supported"),
        ({"element": "_ORIENTATION\n1,1,1,2\n1.0,0.0,0.0"}, "a beam needs a third node, or a vector"),
    ],
)
def test_refused(deck, changes, message):
    with pytest.raises(DeckError, match=message):
        model(deck, **changes)


def test_a_plastic_material_is_refused(deck):
    plastic = "*MAT_PLASTIC_KINEMATIC\n2,7850.0,2.1E11,0.3,1e8\n0.0,0.0,0.0\n"
    with pytest.raises(DeckError, match=r"MID = 2: resultant beams support \*MAT_ELASTIC only"):
        build(deck(DECK.format(element="\n1,1,1,2,3", section=SECTION, material=2) + plastic))
