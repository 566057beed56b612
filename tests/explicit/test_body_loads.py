"""*LOAD_BODY_RX, _RY, _RZ and _PARTS; those along axes are in test_loop.py."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.loop import steps

BALLS = "*NODE\n5,3,4,1\n6,1,0,2\n*ELEMENT_MASS\n105,5,2.0\n106,6,4.0\n"


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_centrifugal_force_points_away_from_the_axis(wall_and, axis):
    model = wall_and(BALLS + f"*LOAD_BODY_R{'XYZ'[axis]}\n1,3.0,0,0.5,0.25,0.125\n")
    next(steps(model))
    r = model.x0[4:] - np.array([0.5, 0.25, 0.125])
    r[:, axis] = 0.0
    np.testing.assert_allclose(model.state.f[4:], np.array([[2.0], [4.0]]) * 9.0 * r, rtol=1e-15)


def test_a_free_mass_flies_outward_as_cosh_and_work_is_its_kinetic_energy(wall_and):
    # r'' = omega^2 r, from rest. Central differences err by (omega dt)^2/24 omega t in the exponent.
    model = wall_and(BALLS + "*LOAD_BODY_RZ\n1,2.0\n", density=1e-3)
    (work,) = energy.accounts(model.forces, "external work")
    for s in steps(model):
        np.testing.assert_allclose(s.x[4, :2], np.cosh(2.0 * s.t) * np.array([3.0, 4.0]), rtol=2 * s.dt**2)
        known = sum(m * s.dt**2 / 8 * (a @ a) for m, a in zip((2.0, 4.0), s.a[4:], strict=True))
        began = 2.0 * s.dt**2 / 8 * (4 * 5.0) ** 2 + 4.0 * s.dt**2 / 8 * 4.0**2
        if s.cycle:
            assert energy.kinetic(s) == pytest.approx(work[0] + known - began, rel=1e-9)


PLATES = """*PART
another
2,1,1
*ELEMENT_SHELL
2,2,11,12,13,14
*NODE
11,5,5,0
12,6,5,0
13,6,6,0
14,5,6,0
*SET_PART_LIST
8
2
"""


def test_body_load_of_parts_pulls_their_nodes_alone(wall_and):
    model = wall_and(BALLS + PLATES + "*LOAD_BODY_PARTS\n8\n*LOAD_BODY_Z\n1,10.0\n*LOAD_BODY_RZ\n1,3.0\n")
    next(steps(model))
    pulled = np.flatnonzero(model.state.a.any(axis=1))
    assert model.ids[pulled].tolist() == [11, 12, 13, 14]
    np.testing.assert_allclose(model.state.a[pulled], model.x0[pulled] * 9.0 - [0.0, 0.0, 10.0])


def test_a_node_of_two_parts_is_refused(wall_and):
    shared = PLATES.replace("11,12,13,14", "3,12,13,14").replace("11,5,5,0\n", "")
    with pytest.raises(DeckError, match=r"\*LOAD_BODY_PARTS: PSID = 8: node 3 belongs to another part"):
        wall_and(shared + "*LOAD_BODY_PARTS\n8\n*LOAD_BODY_Z\n1\n")


def test_a_vector_is_no_keyword(wall_and):
    with pytest.raises(DeckError, match=r"LOAD_BODY_VECTOR"):
        wall_and("*LOAD_BODY_VECTOR\n1\n1.0\n")
