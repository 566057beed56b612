"""Supports, initial velocities, sets and curves as the cards say."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.loop import steps

NODES = (
    "*NODE\n5,0,0,1\n6,1,0,1\n7,2,0,1\n8,3,0,1\n*ELEMENT_MASS\n105,5,1.0\n106,6,1.0\n107,7,1.0\n108,8,1.0\n"
)
SPRING = "*PART\nspring\n9,9,9\n*SECTION_DISCRETE\n9\n\n*MAT_SPRING_ELASTIC\n9,1.0\n"
STEP = "*CONTROL_TIMESTEP\n0.0,0.9,0,0.0,0.0,9\n*DEFINE_CURVE\n9\n0.0,0.001\n9.0,0.001\n"
GRAVITY = "*LOAD_BODY_X\n1,1.0\n*LOAD_BODY_Y\n1,1.0\n*LOAD_BODY_Z\n1,1.0\n"


def moving(model):
    """For each node from the fifth on, the axes along which a body load accelerates it."""
    next(steps(model))
    return ["".join(axis for axis, a in zip("xyz", row, strict=True) if a) for row in model.state.a[4:]]


@pytest.mark.parametrize(
    ("code", "free"),
    [(0, "xyz"), (1, "yz"), (2, "xz"), (3, "xy"), (4, "z"), (5, "x"), (6, "y"), (7, "")],
)
def test_constraint_codes_of_node(wall_and, code, free):
    text = NODES.replace("5,0,0,1\n", f"5,0,0,1,{code}\n", 1)
    assert moving(wall_and(text + GRAVITY)) == [free, "xyz", "xyz", "xyz"]


def test_spc_by_node_and_by_set_add_up(wall_and):
    spc = "*BOUNDARY_SPC_NODE\n5,0,1\n5,0,0,1\n*SET_NODE_LIST\n3\n7,8\n*BOUNDARY_SPC_SET\n3,0,0,0,1\n"
    assert moving(wall_and(NODES + spc + GRAVITY)) == ["z", "xyz", "xy", "xy"]


def test_sets_by_range_part_and_all(wall_and):
    for definition, held in (
        ("*SET_NODE_LIST_GENERATE\n3\n6,7\n", [5, 6]),
        ("*SET_NODE_GENERAL\n3\nNODE,5,8\n", [4, 7]),
        ("*SET_NODE_COLUMN\n3\n5\n8\n", [4, 7]),
        ("*SET_NODE_ADD\n3\n4,5\n*SET_NODE_LIST\n4\n5\n*SET_NODE_LIST_GENERATE\n5\n8,9\n", [4, 7]),
        ("*SET_NODE_GENERAL\n3\nPART,1\n", [0, 1, 2, 3]),
        ("*SET_NODE_GENERAL\n3\nALL\n", list(range(8))),
    ):
        text = NODES.replace("5,0,0,1\n", "5,0,0,1,0\n") + definition + "*BOUNDARY_SPC_SET\n3,0,1,1,1\n"
        model = wall_and(text)
        held_rows = np.flatnonzero(model.constraints[0].fixed[:, 0])
        assert set(held) <= set(held_rows)
        assert set(held_rows) <= set(held) | {0, 1, 2, 3}  # the wall is fixed anyway


def test_reaction_balances_body_force_to_round_off(wall_and):
    model = wall_and(NODES + "*BOUNDARY_SPC_NODE\n5,0,1,1,1\n*LOAD_BODY_Z\n1,386.0\n", end=0.01)
    for s in steps(model):
        held = [0, 1, 2, 3, 4]
        np.testing.assert_allclose(model.constraints[0].reaction[held, 2], 386.0 * s.mass[held], rtol=1e-15)


def test_initial_velocities_later_and_more_special_cards_win(wall_and):
    text = "*INITIAL_VELOCITY\n0\n1.0,2.0,3.0\n*SET_NODE_LIST\n3\n7,8\n*INITIAL_VELOCITY\n3\n4.0\n*INITIAL_VELOCITY_NODE\n8,,,5.0\n"
    model = wall_and(NODES + text)
    assert model.state.v[4:].tolist() == [[1, 2, 3], [1, 2, 3], [4, 0, 0], [0, 0, 5]]
    assert not model.state.v[:4].any()  # a support overrules


def test_exempted_nodes_of_initial_velocity(wall_and):
    text = "*SET_NODE_LIST\n3\n7,8\n*INITIAL_VELOCITY\n0,3\n1.0\n-1.0\n"
    assert wall_and(NODES + text).state.v[4:, 0].tolist() == [1, 1, -1, -1]


def test_a_free_node_without_mass_is_named(wall_and):
    loads = "*LOAD_NODE_POINT\n6,3,1,1.0\n7,3,1,1.0\n"
    with pytest.raises(DeckError, match=r"\*NODE: NID = 6: a free node without mass; give it mass"):
        wall_and(NODES.replace("106,6,1.0\n", "") + loads)
    with pytest.raises(DeckError, match=r"NID = 6: a free node without mass \(2 such nodes\)"):
        wall_and(NODES.replace("106,6,1.0\n107,7,1.0\n", "") + loads)


@pytest.mark.parametrize(
    "more",
    [
        "",
        GRAVITY,
        "*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,1\n",
        "*DAMPING_GLOBAL\n0,3.0\n",
        "*BOUNDARY_SPC_NODE\n99,0,1\n",
        "*SET_NODE_LIST\n1\n99\n*DATABASE_HISTORY_NODE\n99\n",
    ],
)
def test_a_node_that_belongs_to_nothing_stays_at_rest_and_is_said(wall_and, more):
    model = wall_and(NODES + "*NODE\n99,5,5,-5\n*INITIAL_VELOCITY\n0\n1.0\n" + more)
    for _ in steps(model):
        pass
    assert model.state.x[8].tolist() == [5, 5, -5]
    said = [str(finding) for finding in model.idle]
    assert (
        sum("*NODE: NID = 99: belongs to no element and has no mass; it stays at rest" in one for one in said)
        == 1
    )


def test_a_node_of_an_element_without_mass_is_no_node_that_belongs_to_nothing(wall_and):
    with pytest.raises(DeckError, match="NID = 6: a free node without mass"):
        wall_and(NODES.replace("106,6,1.0", "106,5,1.0") + "*ELEMENT_DISCRETE\n1,9,5,6\n" + SPRING)


@pytest.mark.parametrize(
    ("ranges", "held"),
    [("6,6", [5]), ("5,6,8,90", [4, 5, 7]), ("5,6,0,0,8,8", [4, 5, 7]), ("5,6\n0,0\n8,8", [4, 5, 7])],
)
def test_ranges_of_nodes(wall_and, ranges, held):
    text = f"*SET_NODE_LIST_GENERATE\n3\n{ranges}\n*BOUNDARY_SPC_SET\n3,0,1,1,1\n"
    model = wall_and(NODES + text)
    assert np.flatnonzero(model.constraints[0].fixed[:, 0])[4:].tolist() == held


@pytest.mark.parametrize("ranges", ["0,10,0,30", "8,5", "5,6,8,7", "5", "-3,5", "5,6,,8"])
def test_a_range_that_is_none_is_refused(wall_and, ranges):
    text = f"*SET_NODE_LIST_GENERATE\n3\n{ranges}\n*BOUNDARY_SPC_SET\n3,0,1,1,1\n"
    with pytest.raises(DeckError, match="give the first number, then the last; both are positive"):
        wall_and(NODES + text)


@pytest.mark.parametrize(
    ("sets", "moved"),
    [
        ("*SET_PART_LIST_GENERATE\n5\n8,99\n", [4, 5]),
        ("*SET_PART_ADD\n5\n6,7\n*SET_PART_LIST\n6\n9\n*SET_PART_LIST_GENERATE\n7\n90,99\n", [4, 5]),
        ("*SET_PART_LIST\n5\n9\n", [4, 5]),
    ],
)
def test_part_sets_by_list_range_and_other_sets(wall_and, sets, moved):
    text = NODES + "*ELEMENT_DISCRETE\n1,9,5,6\n" + SPRING + sets
    model = wall_and(text + "*INITIAL_VELOCITY_GENERATION\n5,1,0.0,1.0\n\n")
    assert np.flatnonzero(model.state.v[:, 0]).tolist() == moved


@pytest.mark.parametrize(
    ("sets", "message"),
    [
        ("*SET_PART_ADD\n5\n6\n", r"SET_PART_ADD: SETS = 6: no \*SET_PART_... with SID = 6"),
        ("*SET_PART_ADD\n5\n5\n", "SET_PART_ADD: SETS = 5: adds up other sets itself"),
        ("*SET_PART_LIST_GENERATE\n5\n8,7\n", "a range 8 to 7: give the first number"),
        ("*SET_PART_LIST_GENERATE\n5\n80,90\n", "ID = 5: part set 5 has no part of the deck; see deck.k:"),
        ("", r"ID = 5: no \*SET_PART_... with SID = 5; defined: none"),
    ],
)
def test_part_sets_that_name_nothing_are_refused(wall_and, sets, message):
    with pytest.raises(DeckError, match=message):
        wall_and(NODES + sets + "*INITIAL_VELOCITY_GENERATION\n5,1,0.0,1.0\n\n")


EMPTY_PART = "*PART\nwithout elements\n9,1,1\n*SET_PART_LIST\n5\n9\n"
EMPTY_SET = "*SET_NODE_LIST_GENERATE\n4\n100,200\n"


@pytest.mark.parametrize(
    ("card", "message"),
    [
        ("*BOUNDARY_SPC_SET\n4,0,1,1,1\n", "NSID = 4: node set 4 has no node of the deck"),
        ("*LOAD_NODE_SET\n4,3,1,1.0\n", "NSID = 4: node set 4 has no node of the deck"),
        ("*INITIAL_VELOCITY\n4\n1.0\n", "NSID = 4: node set 4 has no node of the deck"),
        ("*INITIAL_VELOCITY\n0,4\n1.0\n2.0\n", "NSIDEX = 4: node set 4 has no node of the deck"),
        ("*BOUNDARY_PRESCRIBED_MOTION_SET\n4,3,0,1\n", "NSID = 4: node set 4 has no node of the deck"),
        ("*RIGIDWALL_PLANAR\n4\n0,0,-1,0,0,1\n", "NSID = 4: node set 4 has no node of the deck"),
        ("*CONSTRAINED_NODAL_RIGID_BODY\n8,0,4\n", "NSID = 4: node set 4 has no node of the deck"),
        ("*INITIAL_VELOCITY_GENERATION\n4,3,0.0,1.0\n\n", "ID = 4: node set 4 has no node of the deck"),
        ("*INITIAL_VELOCITY_GENERATION\n5,1,0.0,1.0\n\n", "ID = 5: names no node"),
        ("*INITIAL_VELOCITY_GENERATION\n9,2,0.0,1.0\n\n", "ID = 9: names no node"),
        ("*LOAD_BODY_X\n1\n*LOAD_BODY_PARTS\n5\n", "PSID = 5: no part of the set has elements"),
        ("*DAMPING_PART_MASS\n9,1\n", "PID = 9: the part has no elements"),
        ("*DAMPING_PART_STIFFNESS\n9,0.1\n", "PID = 9: the part has no deformable elements"),
        ("*SET_NODE_GENERAL\n6\nPART,1,9\n*BOUNDARY_SPC_SET\n6,0,1\n", "E2 = 9: no element of the deck"),
        ("*SET_NODE_GENERAL\n6\nNODE\n*BOUNDARY_SPC_SET\n6,0,1\n", "OPTION = NODE: the numbers that belong"),
        ("*CONTACT_NODES_TO_SURFACE\n4,1,4,3\n\n\n", "SURFA = 4: node set 4 has no node of the deck"),
    ],
)
def test_a_set_without_members_is_refused_wherever_it_is_used(wall_and, card, message):
    with pytest.raises(DeckError, match=message):
        wall_and(NODES + EMPTY_PART + EMPTY_SET + card)


def test_a_curve_with_an_offset_is_zero_before_it(wall_and):
    """A force 2 from t = 0.1 on, on a mass 1: x = (t - 0.1)^2."""
    text = "*DEFINE_CURVE\n2,0,1.0,1.0,0.1\n0.0,2.0\n1.0,2.0\n*LOAD_NODE_POINT\n6,1,2\n"
    model = wall_and(NODES + text + STEP, end=0.2)
    for _ in steps(model):
        pass
    assert model.state.t == pytest.approx(0.2)
    assert model.state.x[5, 0] - 1.0 == pytest.approx(0.01, rel=1e-6)


def test_a_prescribed_velocity_with_an_offset_begins_late(wall_and):
    text = "*DEFINE_CURVE\n2,0,1.0,1.0,0.1\n0.0,3.0\n1.0,3.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n6,1,0,2\n"
    model = wall_and(NODES + text + STEP, end=0.2)
    for _ in steps(model):
        pass
    assert model.state.x[5, 0] - 1.0 == pytest.approx(3.0 * 0.1, rel=1e-6)


@pytest.mark.parametrize(
    ("card", "message"),
    [
        (
            "*CONTROL_TIMESTEP\n0.0,0.9,0,0.0,0.0,2\n",
            "before OFFA of the curve the largest step would be zero",
        ),
        ("*BOUNDARY_PRESCRIBED_MOTION_NODE\n6,1,2,2\n", "a displacement that begins with a jump, 3"),
    ],
)
def test_an_offset_that_makes_no_sense_is_refused(wall_and, card, message):
    with pytest.raises(DeckError, match=message):
        wall_and(NODES + "*DEFINE_CURVE\n2,0,1.0,1.0,0.1\n0.0,3.0\n1.0,3.0\n" + card, end=0.2)


def test_a_load_curve_scales_in_time_and_must_span_the_run(wall_and):
    ramp = "*DEFINE_CURVE\n2\n0.0,0.0\n2.0,4.0\n"
    model = wall_and(NODES + ramp + "*LOAD_BODY_Z\n2,3.0\n", end=1.0)
    for s in steps(model):
        assert s.a[4, 2] == pytest.approx(-3.0 * 2.0 * s.t, abs=1e-12)
    with pytest.raises(
        DeckError, match=r"\*LOAD_BODY_Z: LCID = 2: the curve spans 0 to 2, but the run 0 to 3"
    ):
        wall_and(NODES + ramp + "*LOAD_BODY_Z\n2\n", end=3.0)


def test_work_of_a_ramped_load_is_the_kinetic_energy_it_gives(wall_and):
    from vmharness.explicit import energy

    ramp = "*DEFINE_CURVE\n2\n0.0,0.0\n2.0,4.0\n"
    model = wall_and(NODES + ramp + "*LOAD_BODY_Z\n2,3.0\n", end=1.0)
    (work,) = energy.accounts(model.forces, "external work")
    for s in steps(model):
        a = float(np.abs(s.a[4:]).max())
        assert work[0] == pytest.approx(energy.kinetic(s), abs=4 * s.dt**2 / 8 * a**2 * 1.01 + 1e-15)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ("*BOUNDARY_SPC_NODE\n99,0,1\n", r"\*BOUNDARY_SPC_NODE: NID = 99: no \*NODE 99"),
        ("*BOUNDARY_SPC_SET\n9,0,1\n", r"\*BOUNDARY_SPC_SET: NSID = 9: no .* with SID = 9; defined: none"),
        ("*BOUNDARY_SPC_NODE\n5,0,2\n", r"DOFX = 2: only 0 and 1 are supported"),
        ("*ELEMENT_MASS\n1,77,1.0\n", r"\*ELEMENT_MASS: NID = 77: no \*NODE 77"),
        (
            "*PART\np\n9,8,1\n*ELEMENT_SHELL\n9,9,5,6,7,8\n",
            r"\*PART: SECID = 8: no \*SECTION_SHELL with SECID = 8",
        ),
        (
            "*PART\np\n9,1,8\n*ELEMENT_SHELL\n9,9,5,6,7,8\n",
            r"\*PART: MID = 8: no .*MAT_.* with MID = 8; defined: 1",
        ),
        ("*ELEMENT_SHELL\n9,9,5,6,7,8\n", r"\*ELEMENT_SHELL: PID = .*9.*: no \*PART with PID = 9"),
        (
            "*ELEMENT_SHELL\n9,1,5,6,6,7\n",
            r"\*ELEMENT_SHELL: N1 = 5: has a node twice; a triangle repeats its third",
        ),
        (
            "*SECTION_SHELL\n3,16\n0.1\n*PART\np\n9,3,1\n*ELEMENT_SHELL\n9,9,5,6,7,8\n",
            r"\*SECTION_SHELL: ELFORM = 16: not implemented; supported: 2 \(Belytschko-Tsay\)",
        ),
    ],
)
def test_what_is_wrong_is_said_with_card_field_and_value(wall_and, keywords, message):
    with pytest.raises(DeckError, match=message):
        wall_and(NODES + keywords)
