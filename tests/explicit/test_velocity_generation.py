"""*INITIAL_VELOCITY_GENERATION gives rigid motions."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.loop import steps

PLATE = """*NODE
11,5,5,0
12,6,5,0
13,6,6,0
14,5,6,0
*PART
plate
2,1,1
*ELEMENT_SHELL
2,2,11,12,13,14
*SET_NODE_LIST
3
12,13
*SET_PART_LIST
4
2
"""
AXIS = "1.0,2.0,3.0,0.0,0.0,2.0"  # not a unit vector


def generated(wall_and, head, axis=AXIS):
    return wall_and(PLATE + f"*INITIAL_VELOCITY_GENERATION\n{head}\n{axis}\n").state


@pytest.mark.parametrize(
    ("number", "styp", "rows"),
    [(0, 1, [4, 5, 6, 7]), (4, 1, [4, 5, 6, 7]), (2, 2, [4, 5, 6, 7]), (3, 3, [5, 6])],
)
def test_velocities_are_those_of_a_rigid_motion(wall_and, number, styp, rows):
    s = generated(wall_and, f"{number},{styp},7.0,0.1,0.2,0.3")
    arm = s.x[rows] - [1.0, 2.0, 3.0]
    expected = np.array([0.1, 0.2, 0.3]) + 7.0 * np.column_stack([-arm[:, 1], arm[:, 0], 0.0 * arm[:, 0]])
    np.testing.assert_allclose(s.v[rows], expected, rtol=1e-15)
    np.testing.assert_allclose(s.omega[rows], [[0.0, 0.0, 7.0]] * len(rows))
    others = sorted(set(range(8)) - set(rows))
    assert not s.v[others].any()
    assert not s.omega[others].any()


def test_a_spinning_plate_keeps_its_angular_momentum_to_round_off(wall_and):
    # Forces at t_n of no moment turn v_{n-1/2} into v_{n+1/2}: sum of x_n x m v_{n-1/2} + I omega_{n-1/2} stays.
    axis = "5.5,5.5,0.0,1.0,2.0,3.0"
    model = wall_and(PLATE + f"*INITIAL_VELOCITY_GENERATION\n2,2,6.0,1.0\n{axis}\n", end=1.0)
    s = model.state
    m, inertia = s.mass[4:, None], s.inertia[4:, None]
    spins = np.array(
        [(np.cross(s.x[4:], m * s.v[4:]) + inertia * s.omega[4:]).sum(axis=0) for _ in steps(model)]
    )
    assert np.abs(spins - spins[0]).max() < 1e-12 * np.abs(spins[0]).max()
    np.testing.assert_allclose((m * s.v[4:]).sum(axis=0), [m.sum(), 0.0, 0.0], atol=1e-16)
    assert s.x[4, 2] != 0.0  # it did turn


@pytest.mark.parametrize(
    ("cards", "message"),
    [
        ("2,2,1.0\n\n", r"OMEGA = 1.0: a rotation needs an axis"),
        ("2,2,1.0\n0,0,0,-999.0,11,12\n", r"NX = -999.0: an axis through two nodes is not supported"),
        ("5,2,1.0\n0,0,0,1.0\n", r"ID = 5: no \*PART with PID = 5; defined: 1, 2"),
        ("2,4,1.0\n0,0,0,1.0\n", r"STYP = 4: only 1, 2 and 3 are supported"),
        (
            "2,2,1.0\n0,0,0,1.0\n*INITIAL_VELOCITY_NODE\n11,1.0\n",
            r"not supported together with \*INITIAL_VELOCITY_NODE",
        ),
    ],
)
def test_what_is_refused(wall_and, cards, message):
    with pytest.raises(DeckError, match=message):
        wall_and(PLATE + "*INITIAL_VELOCITY_GENERATION\n" + cards)
