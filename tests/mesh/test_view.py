"""The model of a deck as its picture shows it, whichever solver runs it."""

from pathlib import Path

import numpy as np
import pytest

from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.deck import read as read_text
from vmharness.deck import vocabulary
from vmharness.mesh.view import view_of

CASES = Path(__file__).parents[2] / "cases"


def drawn(name):
    """The model of a case as its picture shows it."""
    return view_of(read_deck(read(CASES / name)))


def test_the_picture_has_solids_and_forces_where_they_act():
    view = drawn("D-51-solid")
    assert view.solids.shape == (98 * 4, 8)
    places, directions = view.arrows["force"]
    assert places.shape == (10, 3)
    assert np.all(places[:, 0] == 1.0)
    assert np.all(directions == [0.0, 0.0, 1.0])


def test_pressure_points_against_the_normal_of_its_segments():
    places, directions = drawn("D-49").arrows["pressure"]  # from within a ring about z
    outward = places * [1.0, 1.0, 0.0] / np.hypot(places[:, 0], places[:, 1])[:, None]
    assert directions == pytest.approx(outward, abs=1e-8)


def test_a_motion_points_the_way_it_goes():
    places, directions = drawn("D-43").arrows["motion"]
    assert np.all(places[:, 1] == 1.0)
    assert np.all(directions == [1.0, 0.0, 0.0])


BODY = """*KEYWORD
*NODE
1,0.0,0.0,0.0
2,2.0,0.0,0.0
3,5.0,0.0,0.0,7,7
*SET_NODE_LIST
1
1,2
*CONSTRAINED_NODAL_RIGID_BODY
1
*DEFINE_CURVE
1
0.0,0.0
1.0,-4.0
*LOAD_RIGID_BODY
1,2,1
*LOAD_NODE_POINT
3,3,1,-1.0
"""


def test_a_load_on_a_rigid_body_is_drawn_at_the_middle_of_its_nodes(tmp_path):
    (tmp_path / "deck.k").write_text(BODY)
    view = view_of(read_text(tmp_path / "deck.k", vocabulary()))
    places, directions = view.arrows["force"]
    assert places.tolist() == [[1.0, 0.0, 0.0], [5.0, 0.0, 0.0]]
    assert directions.tolist() == [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]
    assert view.supports.tolist() == [2]


def test_a_rigid_body_has_its_extra_nodes_and_the_centre_that_its_card_gives():
    (ball,) = drawn("D-26").bodies
    assert (ball.number, ball.name, ball.nodes.size) == (2, "ball", 2000)
    assert ball.centre.tolist() == [0.0, 0.0, 0.1]
    assert not ball.fixed


def test_the_centre_of_rigid_beams_is_that_of_a_uniform_rod_and_they_are_no_deformable_beams():
    view = drawn("D-31")
    rod, ground = view.bodies
    assert view.beams.size == 0
    assert rod.lines.shape == (100, 2)
    ends = view.x[rod.lines[[0, -1], [0, 1]]]
    assert rod.centre == pytest.approx(ends.mean(axis=0), abs=1e-12)
    assert ground.fixed
    assert set(ground.nodes) <= set(view.supports)
    (joint,) = view.joints
    assert joint.name == "spherical joint 1"
    assert view.x[joint.node].tolist() == [0.0, 0.0, 0.0]


def test_a_wall_has_the_side_of_its_nodes_and_says_whether_it_moves():
    right, left = drawn("D-70").walls
    assert (right.name, left.name) == ("right", "left")
    assert right.normal.tolist() == [-1.0, 0.0, 0.0]
    assert left.normal.tolist() == [1.0, 0.0, 0.0]
    assert right.velocity is None
    (moving,) = drawn("VM-083").walls
    assert moving.velocity == 0.0
    (alone,) = drawn("D-22").walls
    assert drawn("D-22").ids[alone.nodes].tolist() == [103]


def test_a_node_that_only_turns_a_cross_section_is_no_part_of_the_model():
    view = drawn("D-51-beam")
    (aside,) = view.orienting
    assert aside not in view.rows
    assert not np.isin(aside, view.beams)


RIGID = """*KEYWORD
*NODE
1,1.0,2.0,3.0
2,3.0,2.0,3.0
3,3.0,6.0,3.0
4,1.0,6.0,3.0
5,1.0,2.0,6.0
6,3.0,2.0,6.0
7,3.0,6.0,6.0
8,1.0,6.0,6.0
9,7.0,4.0,4.5
*ELEMENT_SOLID
1,1,1,2,3,4,5,6,7,8
*PART
block
1,1,1
*SECTION_SOLID
1,1
*MAT_RIGID
1,1.0,1.0,0.3
0
0.0
*RIGIDWALL_PLANAR_FINITE_MOVING
0
8.0,0.0,0.0,7.0,0.0,0.0
8.0,5.0,0.0,10.0,4.0
3.0,2.5
"""


def test_the_centre_of_a_rigid_block_is_that_of_its_volume(tmp_path):
    (tmp_path / "deck.k").write_text(RIGID)
    view = view_of(read_text(tmp_path / "deck.k", vocabulary()))
    (block,) = view.bodies
    assert block.centre == pytest.approx([2.0, 4.0, 4.5])
    assert block.faces.shape == (6, 4)
    assert view.solids.size == 0
    (wall,) = view.walls
    assert wall.velocity == 2.5
    assert wall.edges.tolist() == [[0.0, 10.0, 0.0], [0.0, 0.0, -4.0]]


def test_a_lumped_mass_leaves_the_centre_of_a_rigid_block_open(tmp_path):
    (tmp_path / "deck.k").write_text(RIGID + "*ELEMENT_MASS\n1,1,2.0\n")
    (block,) = view_of(read_text(tmp_path / "deck.k", vocabulary())).bodies
    assert block.centre is None


MOVING = """*KEYWORD
*NODE
1,0.0,0.0,0.0
2,2.0,0.0,0.0
3,0.0,3.0,0.0
*ELEMENT_DISCRETE
1,1,1,2
2,2,1,2
*PART
spring
1,1,1
*PART
damper
2,1,2
*SECTION_DISCRETE
1


*MAT_SPRING_ELASTIC
1,5.0
*MAT_DAMPER_VISCOUS
2,5.0
*SET_NODE_LIST
1
1,2,3
"""
SPIN = "*INITIAL_VELOCITY_GENERATION\n1,3,2.0\n0.0,0.0,0.0,0.0,0.0,1.0\n"


def moving(tmp_path, cards):
    (tmp_path / "deck.k").write_text(MOVING + cards)
    return view_of(read_text(tmp_path / "deck.k", vocabulary()))


def test_a_damper_is_told_from_a_spring(tmp_path):
    assert moving(tmp_path, "").discrete.damper.tolist() == [False, True]


def test_initial_velocities_of_a_rotation_are_across_the_arm(tmp_path):
    places, directions = moving(tmp_path, SPIN).arrows["initial velocity"]
    found = {tuple(at): tuple(along) for at, along in zip(places.tolist(), directions.tolist(), strict=True)}
    assert found == {(2.0, 0.0, 0.0): (0.0, 1.0, 0.0), (0.0, 3.0, 0.0): (-1.0, 0.0, 0.0)}  # omega x r


def test_a_model_at_rest_has_no_initial_velocity(tmp_path):
    assert "initial velocity" not in moving(tmp_path, "").arrows


def test_a_body_moves_as_its_own_card_says(tmp_path):
    body = "*CONSTRAINED_NODAL_RIGID_BODY\n9,,1\n*INITIAL_VELOCITY_RIGID_BODY\n9,0.0,0.0,-4.0,0.0,7.0,0.0\n"
    arrows = moving(tmp_path, SPIN + body).arrows
    places, directions = arrows["initial velocity"]
    assert places == pytest.approx(np.array([[2.0 / 3.0, 1.0, 0.0]]))
    assert directions.tolist() == [[0.0, 0.0, -1.0]]
    assert arrows["initial spin"][1].tolist() == [[0.0, 1.0, 0.0]]


def test_a_spring_to_the_ground_acts_along_its_orientation(tmp_path):
    ground = "*ELEMENT_DISCRETE\n3,1,3,0,4\n*DEFINE_SD_ORIENTATION\n4,0,0.0,-2.0,0.0\n"
    springs = moving(tmp_path, ground).discrete
    assert springs.nodes[2].tolist() == [2, -1]
    assert springs.direction[2].tolist() == [0.0, -1.0, 0.0]
