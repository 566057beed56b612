"""Nodes of shells that can spin about the normal: named, with what turns them."""

import pytest

from vmharness.explicit.build import build
from vmharness.explicit.loop import steps

PLATE = """*KEYWORD
*CONTROL_TERMINATION
1e-3
*PART
plate
1,1,1
*SECTION_SHELL
1,2,1.0,2
0.1
*MAT_ELASTIC
1,7800.0,2.0e11,0.3
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0
5,2.0,0.0,0.0
6,2.0,1.0,{z}
7,0.0,0.0,1.0
8,5.0,5.0,5.0,7,7
*ELEMENT_SHELL
1,1,1,2,3,4
2,1,2,5,6,3
*DEFINE_CURVE
1
0.0,1.0
10.0,1.0
"""
MOMENT = "*LOAD_NODE_POINT\n{node},{dof},1,10.0\n"
BEAM = "*PART\nbeam\n2,2,1\n*SECTION_BEAM\n2,2\n0.01,1e-5,1e-5,2e-5\n*ELEMENT_BEAM\n9,2,1,7,8\n"
REST = "*ELEMENT_MASS\n1,7,1.0\n"
TORSION = "*PART\nspring\n3,3,3\n*SECTION_DISCRETE\n3,1\n\n*MAT_SPRING_ELASTIC\n3,1e4\n*ELEMENT_DISCRETE\n8,3,4,0,1\n"
AXIS = "*DEFINE_SD_ORIENTATION\n1,0,{}\n"


def spinning(deck, cards, z=0.0):
    """What the model says of free rotations."""
    model = build(deck(PLATE.format(z=z) + REST + cards + "*END\n"))
    return {name: fact for name, fact in model.facts.items() if name.startswith("Free rotation")}, model


def test_a_moment_about_the_normal_is_named_and_spins_the_node(deck):
    facts, model = spinning(deck, MOMENT.format(node=3, dof=7))
    assert list(facts) == ["Free rotation by nodal loads of curve 1"]
    assert facts["Free rotation by nodal loads of curve 1"].startswith(
        "node 3 can spin: the shells there do not"
    )
    *_, s = steps(model)
    assert s.omega[2, 2] == pytest.approx(10.0 * s.t / s.inertia[2], rel=0.1)


@pytest.mark.parametrize(
    "cards",
    [
        "",
        MOMENT.format(node=3, dof=5),
        MOMENT.format(node=3, dof=7) + "*BOUNDARY_SPC_NODE\n3,0,0,0,0,0,0,1\n",
        MOMENT.format(node=7, dof=7),
        TORSION + AXIS.format("1.0,0.0,0.0"),
    ],
)
def test_what_does_not_turn_about_the_normal_or_is_held_is_not_named(deck, cards):
    assert spinning(deck, cards)[0] == {}


def test_ends_of_beams_and_torsional_springs_are_named(deck):
    facts, _ = spinning(deck, BEAM)
    assert facts["Free rotation by beams of part 2"].startswith("node 1 can spin")
    facts, _ = spinning(deck, TORSION + AXIS.format("0.0,0.0,1.0"))
    assert facts["Free rotation by springs and dampers of part 3"].startswith("node 4 can spin")


def test_shells_at_an_angle_hold_each_other(deck):
    """Node 3 belongs to a plane shell and to one that is not in its plane: that resists."""
    fact = spinning(deck, MOMENT.format(node=3, dof=7), z=0.5)[0]
    assert fact == {}
