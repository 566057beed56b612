"""Joints: they hold to round-off, do no work, and give the pendulum its period and its pin its force."""

import math

import numpy as np
import pytest
from scipy.special import ellipk

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

# Body 3 swings about the origin, in the x-z plane; body 4 is the ground.
GROUND = """*SECTION_SOLID
4,1
*MAT_RIGID
4,1.0,100.0,0.3
1,7,7

*NODE
12,0.0,0.0,0.0
13,0.0,0.0,0.0
14,0.0,1.0,0.0
15,0.0,1.0,0.0
*CONSTRAINED_EXTRA_NODES_NODE
4,13
3,12
4,15
3,14
*PART_INERTIA
ground
4,4,4
0.0,0.0,0.0,1.0
1.0,0.0,0.0,1.0,0.0,1.0

"""
SPHERICAL = "*CONSTRAINED_JOINT_SPHERICAL\n12,13\n"
REVOLUTE = "*CONSTRAINED_JOINT_REVOLUTE\n12,13,14,15\n"
GRAVITY = "*LOAD_BODY_Z\n1,9.81\n"
ROD = """*SECTION_SOLID
3,1
*MAT_RIGID
3,1.0,100.0,0.3


*PART_INERTIA
rod
3,3,3
0.5,0.0,0.0,2.0
{spin},0.0,0.0,0.16666666666666666,0.0,0.16666666666666666
{velocity}
"""


def rod(spin=1e-3, velocity=""):
    """A rod of length 1 and mass 2 from the origin along x."""
    return ROD.format(spin=spin, velocity=velocity)


def worst(model, quantity):
    return max(abs(quantity(s)) for s in steps(model))


@pytest.mark.parametrize("joint", [SPHERICAL, REVOLUTE])
def test_a_rod_released_from_the_horizontal_has_its_period_speed_and_pin_force(space, bodies, joint):
    model = space(rod() + GROUND + joint + GRAVITY, end=1.0, step=1e-3)
    x, force = probe(model, rigid=3, component="x-coordinate"), probe(model, joint=1, component="z-force")
    spin = probe(model, rigid=3, component="y-angular-velocity")
    history = np.array([(s.t, x(), force(), spin()) for s in steps(model)]).T
    t, x, force, spin = history
    quarter = math.sqrt(2 / (3 * 9.81)) * ellipk(0.5)
    i = np.flatnonzero(x < 0)[0]
    passing = t[i - 1] + 1e-3 * x[i - 1] / (x[i - 1] - x[i])
    assert passing == pytest.approx(quarter, rel=3e-6)
    assert np.interp(quarter, t, spin) == pytest.approx(math.sqrt(3 * 9.81), rel=1e-5)
    assert np.interp(quarter, t, force) == pytest.approx(2.5 * 2.0 * 9.81, rel=1e-5)
    assert force[0] == pytest.approx(2.0 * 9.81 / 4, rel=1e-9)


def test_a_joint_stays_closed_and_does_no_work(space, bodies):
    model = space(rod(velocity="0.0,0.5,0.0,2.0,0.0,1.0") + GROUND + SPHERICAL + GRAVITY, end=5.0, step=2e-3)
    (work,) = energy.accounts(model.forces, "external work")
    begun, off, open_ = None, 0.0, 0.0
    for s in steps(model):
        begun = begun or model.kinetic()
        off = max(off, abs(model.kinetic() - work[0] - begun))
        rows = [model.ids.tolist().index(nid) for nid in (12, 13)]
        open_ = max(open_, np.abs(s.x[rows[0]] - s.x[rows[1]]).max())
    assert open_ < 1e-13
    assert off < 2e-4 * 2.0 * 9.81 * 0.5


def test_order_of_the_joint_is_two(space):
    ends = []
    for step in (8e-3, 4e-3, 2e-3, 2.5e-4):
        text = rod(velocity="0.0,0.5,0.0,2.0,0.0,1.0") + GROUND + SPHERICAL + GRAVITY
        model = space(text, end=1.5999, step=step)
        *_, s = steps(model)
        assert s.t == pytest.approx(1.6, rel=1e-12)
        ends.append(s.x[model.centre(3)].copy())
    errors = [np.linalg.norm(end - ends[-1]) for end in ends[:-1]]
    np.testing.assert_allclose(np.divide(errors[:-1], errors[1:]), 4.0, rtol=0.1)


def test_two_bodies_that_are_joined_in_space_keep_momentum_and_angular_momentum(space, bodies):
    other = GROUND.replace("1,7,7", "").replace(
        "*PART_INERTIA\nground\n4,4,4\n0.0,0.0,0.0", "*PART_INERTIA\nground\n4,4,4\n-1.0,0.0,0.0"
    )
    spin = other.rstrip("\n").rpartition("\n")[0] + "\n1.0,0.0,0.0,1.0,0.0,1.0\n0.0,1.0,0.0,0.0,0.0,0.0\n"
    model = space(rod() + spin + SPHERICAL, end=4.0, step=2e-3)
    b, s, c = bodies(model), model.state, [model.centre(3), model.centre(4)]
    mass = s.mass[c][:, None]
    found = []
    for _ in steps(model):
        v = s.v[c] + 0.5 * s.dt * s.a[c]
        own = b.angular_momentum(0) + b.angular_momentum(1)
        found.append([*(mass * v).sum(axis=0), *(np.cross(s.x[c], mass * v).sum(axis=0) + own)])
    found = np.array(found)
    np.testing.assert_allclose(found[:, :3], found[:1, :3].repeat(len(found), 0), atol=1e-13)
    assert np.abs(found[:, 3:] - found[0, 3:]).max() < 1e-5 * np.abs(found[0]).max()
    assert s.x[c[0], 1] != 0.0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("*CONSTRAINED_JOINT_SPHERICAL\n12,14\n", r"N2 = 14: belongs to the body of N1"),
        ("*CONSTRAINED_JOINT_SPHERICAL\n12,15\n", r"N2 = 15: does not lie where N1 lies"),
        ("*CONSTRAINED_JOINT_SPHERICAL\n12,16\n*NODE\n16,0,0,0,7\n", r"N2 = 16: no node of a rigid body"),
        ("*CONSTRAINED_JOINT_REVOLUTE\n12,13,12,13\n", r"N3 = 12: lies where N1 lies"),
        (SPHERICAL + "*DAMPING_GLOBAL\n0,1.0\n", "not supported with mass damping"),
    ],
)
def test_what_is_no_joint_is_refused(space, text, message):
    with pytest.raises(DeckError, match=message):
        space(rod() + GROUND + text)
