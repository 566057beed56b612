"""*DAMPING_GLOBAL and *DAMPING_PART_MASS against exact decay, and the order that they claim."""

import math

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

BALL = "*NODE\n5,0.0,0.0,{z}\n*ELEMENT_MASS\n9,5,0.5\n*INITIAL_VELOCITY_NODE\n5,,,-0.01\n"
SPRING = "*SET_NODE_LIST\n2\n5\n*CONTROL_CONTACT\n1.0\n\n*CONTACT_NODES_TO_SURFACE\n2,1,4,3\n\n\n"
OMEGA = math.sqrt(math.sqrt(2.0) / 0.5)  # of the wall's penalty: a linear spring while the ball is behind it


def decay(wall_and, density, card="0,2.0", end=1.0):
    return wall_and(BALL.format(z=50.0) + f"*DAMPING_GLOBAL\n{card}\n", end=end, density=density)


def test_a_free_mass_slows_down_exponentially_with_order_two(wall_and):
    errors = []
    for density in (4e-2, 1e-2, 2.5e-3):
        model = decay(wall_and, density)
        v = probe(model, node=5, component="z-velocity")
        errors.append(max(abs(v() + 0.01 * math.exp(-2.0 * s.t)) for s in steps(model)))
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 2.0, atol=0.1)
    assert errors[-1] < 1e-3 * 0.01


def test_what_kinetic_energy_loses_is_damping(wall_and):
    model = decay(wall_and, density=1e-2)
    ratio, s = probe(model, energy="ratio"), model.state
    assert max(abs(ratio() - 1.0) for _ in steps(model)) < 2 * (2.0 * s.dt) ** 2
    taken = 0.25e-4 * (1 - math.exp(-4.0 * s.t))
    assert model.constraints[-1].energy["damping"][0] == pytest.approx(taken, rel=4 * s.dt**2)


def test_damping_sets_no_limit_to_the_step(wall_and):
    # v_{n+1/2} = (1 - h/2)/(1 + h/2) v_{n-1/2}: with h = D dt = 10, where a lagged dashpot has the factor 1 - h = -9.
    model = decay(wall_and, density=1e-2, card="0,200.0", end=3.0)
    v = np.array([s.v[4, 2] for s in steps(model)])[1:]
    h = 200.0 * model.state.dt
    assert h > 5.0
    np.testing.assert_allclose(v[1:] / v[:-1], (1 - h / 2) / (1 + h / 2), rtol=1e-9)


def test_critical_damping_of_an_oscillator(wall_and):
    # z = -v0 t exp(-omega t): no oscillation, order two.
    errors = []
    for density in (4e-2, 1e-2, 2.5e-3):
        text = BALL.format(z=0.0) + SPRING + f"*DAMPING_GLOBAL\n0,{2.0 * OMEGA}\n"
        model = wall_and(text, end=3.0, density=density)
        errors.append(max(abs(s.x[4, 2] + 0.01 * s.t * math.exp(-OMEGA * s.t)) for s in steps(model)))
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 2.0, atol=0.15)


def test_directions_and_curve(wall_and):
    ramp = "*DEFINE_CURVE\n2\n0.0,0.0\n5.0,10.0\n*INITIAL_VELOCITY\n0\n0.01,0.01,-0.01\n"
    text = BALL.format(z=50.0).replace("*INITIAL_VELOCITY_NODE\n5,,,-0.01\n", "") + ramp
    model = wall_and(text + "*DAMPING_GLOBAL\n2,0.0,0.0,1.0,0.5\n")
    for s in steps(model):
        v = s.v[4] + 0.5 * s.dt * s.a[4]
        expected = [0.01, 0.01 * math.exp(-(s.t**2)), -0.01 * math.exp(-0.5 * s.t**2)]  # D = 2 t
        np.testing.assert_allclose(v, expected, rtol=2 * s.dt**2 + 1e-12)


PLATES = """*PART
another
2,1,1
*ELEMENT_SHELL
2,2,11,12,13,14
*PART
third
3,1,1
*ELEMENT_SHELL
3,3,{last},16,17,18
*NODE
11,5,5,0
12,6,5,0
13,6,6,0
14,5,6,0
15,8,5,0
16,9,5,0
17,9,6,0
18,8,6,0
*INITIAL_VELOCITY
0
0.0,0.0,1.0
*DEFINE_CURVE
2
0.0,2.0
9.0,2.0
"""


def test_a_part_is_damped_and_its_neighbours_are_not(wall_and):
    model = wall_and(
        PLATES.format(last=15).replace("15,8,5,0\n", "15,8,5,0\n") + "*DAMPING_PART_MASS\n2,2,0.5\n"
    )
    for s in steps(model):
        v = s.v[4:, 2] + 0.5 * s.dt * s.a[4:, 2]
        np.testing.assert_allclose(v[:4], math.exp(-s.t), rtol=s.dt**2)
        np.testing.assert_allclose(v[4:], 1.0, rtol=1e-12)


def test_the_reaction_of_a_support_is_not_touched(wall_and):
    damped = "*LOAD_NODE_POINT\n1,3,1,5.0\n*DAMPING_GLOBAL\n0,100.0\n"
    model = wall_and(damped)
    for _ in steps(model):
        assert probe(model, support="all", component="z-force")() == -5.0
    assert energy.accounts(model.constraints, "damping")[0][0] == 0.0


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ("*DAMPING_GLOBAL\n0,1.0\n*DAMPING_PART_MASS\n2,2\n", r"not supported beside \*DAMPING_GLOBAL"),
        ("*DAMPING_GLOBAL\n0,-1.0\n", r"VALDMP = -1.0: must be at least 0"),
        ("*DAMPING_PART_MASS\n2,2\n", r"PID = 2: node 13 belongs to a part with other damping as well"),
        ("*DAMPING_PART_MASS\n2,2\n3,2,3.0\n", r"PID = 3: node 13 belongs to a part with other damping"),
        ("*DAMPING_PART_MASS\n7,2\n", r"PID = 7: no \*PART with PID = 7"),
        (
            "*DAMPING_GLOBAL\n0,1.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n11,3,0,1,1.0,0,0.5\n",
            r"\*DAMPING_GLOBAL: not supported with prescribed motion 1",
        ),
    ],
)
def test_what_is_refused(wall_and, keywords, message):
    with pytest.raises(DeckError, match=message):
        wall_and(PLATES.format(last=13).replace("15,8,5,0\n", "") + keywords)


def test_parts_that_share_nodes_may_have_one_damping(wall_and):
    model = wall_and(PLATES.format(last=13).replace("15,8,5,0\n", "") + "*DAMPING_PART_MASS\n2,2\n3,2\n")
    next(steps(model))
    np.testing.assert_allclose(model.state.a[4:, 2], -2.0)
