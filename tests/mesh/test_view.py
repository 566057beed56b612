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
