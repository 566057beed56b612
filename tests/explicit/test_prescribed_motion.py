"""*BOUNDARY_PRESCRIBED_MOTION: nodes follow their curve at every step, and the account of its work closes."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import ProbeError, probe

BALLS = "*NODE\n5,0,0,1\n6,1,0,1\n*ELEMENT_MASS\n105,5,2.0\n106,6,4.0\n*SET_NODE_LIST\n3\n5,6\n"
BENT = "*DEFINE_CURVE\n2\n0.0,0.0\n0.3,0.6\n0.5,-0.2\n2.0,0.7\n"  # bends between steps
T, C = np.array([0.0, 0.3, 0.5, 2.0]), np.array([0.0, 0.6, -0.2, 0.7])
SET = "*BOUNDARY_PRESCRIBED_MOTION_SET\n3,{dof},{vad},2,3.0\n"


def integral(t):
    """Of the bent curve from 0 to t."""
    inner = np.concatenate([T[t > T], [t]])
    return np.trapezoid(np.interp(inner, T, C), inner)


def balance(model):
    """A probe of total energy less what was put in."""
    total, work = probe(model, energy="total"), probe(model, energy="external work")
    initial = energy.kinetic(model.state)
    return lambda: total() - initial - work()


def test_velocity_and_position_are_exact_at_every_step(wall_and):
    model = wall_and(BALLS + BENT + SET.format(dof=3, vad=0))
    v, closes = probe(model, node=6, component="z-velocity"), balance(model)
    for s in steps(model):
        assert v() == pytest.approx(3.0 * np.interp(s.t, T, C), abs=1e-13)
        np.testing.assert_allclose(s.x[4:6, 2], 1.0 + 3.0 * integral(s.t), rtol=1e-12)
        assert closes() == pytest.approx(0.0, abs=1e-13)
    assert s.cycle > 50


def test_displacement_is_exact_at_every_step(wall_and):
    model = wall_and(BALLS + BENT + SET.format(dof=1, vad=2))
    closes, kinetic = balance(model), []
    v, work = probe(model, node=5, component="x-velocity"), probe(model, energy="external work")
    for s in steps(model):
        kinetic.append((v(), model.kinetic(), work()))
        np.testing.assert_allclose(s.x[4:6, 0], np.array([0.0, 1.0]) + 3.0 * np.interp(s.t, T, C), atol=1e-12)
        assert closes() == pytest.approx(0.0, abs=1e-11)
    # LS-DYNA's first state has v = 0 and no kinetic energy, for any slope; one step later the slope is there.
    assert kinetic[0] == (0.0, 0.0, 0.0)
    mass = model.state.mass[4:6].sum()
    assert kinetic[1] == pytest.approx((6.0, 18.0 * mass, 18.0 * mass), rel=1e-12)


def test_acceleration_is_exact_and_constant_one_gives_a_parabola(wall_and):
    model = wall_and(BALLS + BENT + SET.format(dof=3, vad=1) + "*INITIAL_VELOCITY\n3\n0.0,0.0,5.0\n")
    force = probe(model, motion=1, component="z-force")
    for s in steps(model):
        assert s.a[4:6, 2].tolist() == pytest.approx([3.0 * np.interp(s.t, T, C)] * 2, abs=1e-15)
        assert force() == pytest.approx(6.0 * s.a[4, 2], rel=1e-14)  # on both masses
    motion = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,1,1,1,2.0\n"
    for s in steps(model := wall_and(BALLS + motion)):
        assert s.x[4, 0] == pytest.approx(s.t**2, abs=1e-12)


def test_reaction_holds_against_a_load_and_takes_back_its_work(wall_and):
    # Under a load of 7, moved at constant speed: the reaction is -7, and the load's work goes into the motion.
    load = "*LOAD_NODE_POINT\n5,3,1,7.0\n"
    model = wall_and(BALLS + load + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,3,0,1,0.5\n")
    force, closes = probe(model, motion=1, component="z-force"), balance(model)
    for _ in steps(model):
        assert force() == pytest.approx(-7.0, rel=1e-12)
        assert closes() == pytest.approx(0.0, abs=1e-13)
    assert model.constraints[0].energy["external work"][0] == pytest.approx(
        -7.0 * 0.5 * model.state.t, rel=1e-12
    )
    with pytest.raises(ProbeError, match="no prescribed motion 2; the deck has 1"):
        probe(model, motion=2, component="z-force")


def test_rotation_is_prescribed_like_translation(wall_and):
    # A fixed wall but for one rotation of node 1.
    model = wall_and(
        "*NODE\n9,0,0,0\n*ELEMENT_MASS\n9,9,1.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n9,7,0,1,2.0\n"
    )
    for s in steps(model):
        assert s.omega[4, 2] == 2.0
    assert probe(model, motion=1, component="z-moment")() == 0.0  # a point has no inertia


def test_birth_shifts_the_curve_and_death_lets_go(wall_and):
    motion = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n5,3,0,2,1.0,0,0.7,0.5\n"
    model = wall_and(BALLS + BENT + motion + "*INITIAL_VELOCITY\n0\n0.0,0.0,-1.0\n")
    v, closes = probe(model, node=5, component="z-velocity"), balance(model)
    last = None
    for s in steps(model):
        if s.t < 0.5:
            assert v() == -1.0
        elif s.t < 0.7:
            assert v() == pytest.approx(np.interp(s.t - 0.5, T, C), abs=1e-12)
        else:
            last = v() if last is None else last
            assert v() == pytest.approx(last, rel=1e-12)
            assert probe(model, motion=1, component="z-force")() == 0.0
        assert closes() == pytest.approx(0.0, abs=1e-12)
    assert last == pytest.approx(0.4, abs=2.0 * s.dt)


@pytest.mark.parametrize("vad", [0, 1, 2])
def test_work_on_an_elastic_body_balances(wall_and, vad):
    # A free shell pulled by an edge: internal, hourglass and kinetic energy against the work of the motion.
    plate = "*NODE\n5,5,5,0\n6,6,5,0\n7,6,6,0\n8,5,6,0\n*ELEMENT_SHELL\n2,1,5,6,7,8\n*SET_NODE_LIST\n3\n6,7\n"
    smooth = "*DEFINE_CURVE\n2\n" + "".join(
        f"{t},{1e-3 * t**2 * (3 - 2 * t)}\n" for t in np.linspace(0, 1, 41)
    )
    motion = f"*BOUNDARY_PRESCRIBED_MOTION_SET\n3,1,{vad},2\n*CONTROL_TIMESTEP\n0.0,0.1\n"
    model = wall_and(plate + smooth + motion, end=0.99)
    closes, kinetic = balance(model), probe(model, energy="kinetic")
    off, size = np.array([(closes(), kinetic()) for _ in steps(model)]).T
    # Leapfrog's own m dt^2/8 a^2 of the free nodes, with omega dt = 0.14 of the shell.
    assert np.abs(off).max() < 0.14**2 / 8.0 * size.max()


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ("1,3,0,1\n", r"MOTION_NODE: DOF = 3: node 1 is already prescribed by a support in this direction"),
        (
            "5,3,0,1\n5,3,1,1\n",
            r"MOTION_NODE: DOF = 3: node 5 is already prescribed by another prescribed motion",
        ),
        ("5,3,2,1\n", r"LCID = 1: a displacement that begins with a jump, 1; let it begin at 0"),
        ("5,4,0,1\n", r"DOF = 4: only 1, 2, 3, 5, 6 and 7 are supported"),
        ("5,3,3,1\n", r"VAD = 3: only 0, 1 and 2 are supported"),
        ("5,3,0,1,1.0,2\n", r"VID = 2: only 0 is supported"),
        ("5,3,0,1,1.0,0,0.2,0.5\n", r"DEATH = 0.2: the motion would end before its birth at 0.5"),
    ],
)
def test_what_is_refused(wall_and, keywords, message):
    with pytest.raises(DeckError, match=message):
        wall_and(BALLS + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + keywords)
