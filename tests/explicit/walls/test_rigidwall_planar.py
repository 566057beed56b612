"""*RIGIDWALL_PLANAR: plastic impact of nodes, friction, moving and finite walls, release, conservation, errors."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import ProbeError, probe
from vmharness.explicit.walls.wall import PlanarWall

PLAIN = "*RIGIDWALL_PLANAR\n0\n{0},{1}\n"


def ball(x=0.0, y=0.0, z=1.0, mass=2.0, v=(0.0, 0.0, -3.0), nid=5):
    velocity = f"*INITIAL_VELOCITY_NODE\n{nid},{v[0]},{v[1]},{v[2]}\n" if any(v) else ""
    return f"*NODE\n{nid},{x},{y},{z}\n*ELEMENT_MASS\n{nid + 100},{nid},{mass}\n{velocity}"


def wall(place=0.0, fric="", kind="", cards="", **first):
    """A wall across z, with its normal to +z, for the ball of node 5 unless NSID says otherwise."""
    fields = {"nsid": 0, "nsidex": "", "boxid": "", "offset": "", "birth": "", "death": ""} | first
    line = ",".join(map(str, fields.values()))
    return f"*RIGIDWALL_PLANAR{kind}\n{line}\n0.0,0.0,{place},0.0,0.0,{place + 1.0},{fric}\n{cards}"


# A rigid body of two masses that falls beside the ball.
BODY = """*CONSTRAINED_NODAL_RIGID_BODY
20,,20
*SET_NODE_LIST
20
21,22
*NODE
21,3.0,0.0,0.5
22,3.0,0.0,0.8
*ELEMENT_MASS
21,21,1.0
22,22,1.0
*INITIAL_VELOCITY_RIGID_BODY
20,0.0,0.0,-3.0
*CONTROL_CONTACT
,{rwpnal}

"""


def wall_of(model):
    """The first wall of a model."""
    return next(item for item in model.constraints if isinstance(item, PlanarWall))


def history(model, row=4):
    """t, x, v_n, wall force of every cycle as columns t, x, y, z, vx, ... fz, and the energy ratio."""
    ratio, out = probe(model, energy="ratio"), []
    for s in steps(model):
        v = s.v[row] + 0.5 * s.dt * s.a[row]
        out.append((s.t, *s.x[row], *v, *wall_of(model).force, ratio()))
    names = ("t", "x", "y", "z", "vx", "vy", "vz", "fx", "fy", "fz", "ratio")
    return SimpleNamespace(**dict(zip(names, np.array(out).T, strict=True)))


def test_a_node_is_stopped_on_the_wall_and_no_sample_is_behind(wall_and):
    model = wall_and(ball() + wall(), end=1.0)
    h = history(model)
    assert h.z.min() >= -1e-15
    np.testing.assert_allclose(h.z, np.maximum(1.0 - 3.0 * h.t, 0.0), atol=1e-14)
    assert h.vz[0] == -3.0
    assert abs(h.vz[-1]) < 1e-14
    np.testing.assert_allclose(wall_of(model).impulse, [0.0, 0.0, 2.0 * 3.0], rtol=1e-14)
    assert wall_of(model).energy["rigid wall"][0] == pytest.approx(0.5 * 2.0 * 9.0, rel=1e-14)
    np.testing.assert_allclose(h.ratio[[0, -1]], 1.0, rtol=1e-14)
    assert np.count_nonzero(h.fz) <= 2


def test_the_force_adds_up_to_the_impulse(wall_and):
    model = wall_and(ball() + wall() + "*LOAD_BODY_Z\n1,4.0\n", end=1.0)
    h = history(model)
    acted = 0.5 * (np.append(np.diff(h.t), 0.0) + np.insert(np.diff(h.t), 0, 0.0))
    assert h.fz @ acted == pytest.approx(wall_of(model).impulse[2], rel=1e-12)
    # It stops the fall of v0 = -3, and carries the weight.
    assert wall_of(model).impulse[2] == pytest.approx(2.0 * (3.0 + 4.0 * h.t[-1]), rel=1e-12)


def test_a_node_at_rest_weighs_on_the_wall(wall_and):
    model = wall_and(ball(z=0.0, v=(0, 0, 0)) + wall() + "*LOAD_BODY_Z\n1,9.81\n", end=0.1)
    h = history(model)
    np.testing.assert_allclose(h.fz, 2.0 * 9.81, rtol=1e-14)
    assert not h.z.any()
    assert not h.vz.any()
    np.testing.assert_array_equal(h.ratio, 1.0)


def test_it_lets_go_when_the_load_pulls(wall_and):
    """f = -m cos(t - ...): pressed first, then pulled off from the zero of the load on."""
    load = "*DEFINE_CURVE\n7\n0.0,-1.0\n2.0,1.0\n*LOAD_NODE_POINT\n5,3,7,1.0\n"
    model = wall_and(ball(z=0.0, mass=2.0, v=(0, 0, 0)) + wall() + load, end=2.0)
    h = history(model)
    np.testing.assert_allclose(h.fz, np.maximum(1.0 - h.t, 0.0), atol=1e-12)
    since = np.maximum(h.t - 1.0, 0.0)
    np.testing.assert_allclose(h.z, since**3 / 12.0, atol=2e-4)
    np.testing.assert_allclose(h.vz, since**2 / 4.0, atol=1e-3)


@pytest.mark.parametrize(("fric", "sideways"), [(0.0, 2.0), (0.25, 2.0 - 0.25 * 3.0), (0.9, 0.0), (1.0, 0.0)])
def test_friction_takes_up_to_its_share_of_the_normal_impulse(wall_and, fric, sideways):
    model = wall_and(ball(v=(2.0, 0.0, -3.0)) + wall(fric=fric), end=0.5)
    h = history(model)
    assert h.vx[-1] == pytest.approx(sideways, rel=1e-13, abs=1e-14)
    np.testing.assert_allclose(wall_of(model).impulse, [2.0 * (sideways - 2.0), 0.0, 6.0], rtol=1e-12)
    assert h.ratio[-1] == pytest.approx(1.0, rel=1e-13)


def test_a_block_slides_to_rest_by_friction(wall_and):
    """D22: v0 = 5, f = 0.3, g = 9.81: at rest after v0/(f g) and v0^2/(2 f g), and then it stays."""
    f, g, v0, m = 0.3, 9.81, 5.0, 2.0
    model = wall_and(ball(z=0.0, v=(v0, 0, 0)) + wall(fric=f) + f"*LOAD_BODY_Z\n1,{g}\n", end=2.0)
    h = history(model)
    stop = v0 / (f * g)
    np.testing.assert_allclose(
        h.x, np.where(h.t < stop, v0 * h.t - f * g * h.t**2 / 2, v0**2 / (2 * f * g)), atol=2e-4
    )
    assert np.ptp(h.x[h.t > stop + 0.02]) == 0.0
    np.testing.assert_allclose(h.fx[(h.t > 0.1) & (h.t < stop - 0.02)], -f * m * g, rtol=1e-12)
    np.testing.assert_allclose(h.fz, m * g, rtol=1e-12)
    assert wall_of(model).energy["rigid wall"][0] == pytest.approx(m * v0**2 / 2, rel=1e-4)
    np.testing.assert_allclose(h.ratio, 1.0, atol=1e-4)


def test_friction_holds_what_is_pushed_below_its_limit(wall_and):
    """Weight of 2 x 10 and f = 0.5: a push of 9 does not move it, one of 12 does."""
    for push, moved in ((9.0, 0.0), (12.0, 0.5 * (12.0 - 10.0) / 2.0 * 0.5**2)):
        load = f"*LOAD_NODE_POINT\n5,1,1,{push}\n*LOAD_BODY_Z\n1,10.0\n"
        model = wall_and(ball(z=0.0, v=(0, 0, 0)) + wall(fric=0.5) + load, end=0.5)
        h = history(model)
        assert h.x[-1] == pytest.approx(moved * (h.t[-1] / 0.5) ** 2, rel=1e-2, abs=1e-300)


def test_a_moving_wall_shares_its_momentum(wall_and):
    m, mass, v0, speed = 2.0, 3.0, -3.0, 0.5
    model = wall_and(ball(v=(0, 0, v0)) + wall(kind="_MOVING", cards=f"{mass},{speed}\n"), end=1.0)
    momentum, energies = m * v0 + mass * speed, m * v0**2 / 2 + mass * speed**2 / 2
    common = momentum / (m + mass)
    for s in steps(model):
        w = wall_of(model)
        assert m * s.v[4, 2] + mass * w.motion[1] == pytest.approx(momentum, rel=1e-13)
        assert s.x[4, 2] >= w.motion[0] - 1e-14
    assert s.v[4, 2] == pytest.approx(common, rel=1e-13)
    assert probe(model, wall=1, component="z-velocity")() == pytest.approx(common, rel=1e-13)
    meets = 1.0 / (speed - v0)
    assert probe(model, wall=1, component="normal-displacement")() == pytest.approx(
        speed * meets + common * (s.t - meets), rel=5e-3
    )
    lost = 0.5 * m * mass / (m + mass) * (v0 - speed) ** 2
    assert w.energy["rigid wall"][0] == pytest.approx(lost + mass * common**2 / 2, rel=1e-13)
    assert energy.kinetic(s) + w.energy["rigid wall"][0] == pytest.approx(energies, rel=1e-13)


def test_a_moving_wall_and_two_nodes_come_to_one_velocity(wall_and):
    """One node lies on the wall and rests; the other meets both."""
    two = ball(z=0.0, mass=1.0, v=(0, 0, 0)) + ball(x=0.5, z=0.3, mass=2.0, v=(0, 0, -3.0), nid=6)
    model = wall_and(two + wall(kind="_MOVING", cards="3.0\n"), end=0.5)
    *_, s = steps(model)
    # The node at rest is left behind by the wall, which is pushed away from it.
    assert s.v[4, 2] == 0.0
    assert s.v[5, 2] == pytest.approx(-6.0 / 5.0, rel=1e-13)
    assert wall_of(model).motion[1] == pytest.approx(-6.0 / 5.0, rel=1e-13)


def test_a_moving_wall_pushes_what_a_force_holds_against_it(wall_and):
    """F on a node of mass m at a wall of mass M: both move with F/(m + M), and the wall force is M F/(m + M)."""
    push = "*LOAD_NODE_POINT\n5,3,1,-10.0\n"
    model = wall_and(ball(z=0.0, v=(0, 0, 0)) + wall(kind="_MOVING", cards="3.0\n") + push, end=1.0)
    h = history(model)
    np.testing.assert_allclose(h.fz, 6.0, rtol=1e-12)
    np.testing.assert_allclose(h.z, -2.0 * h.t**2 / 2, rtol=1e-11, atol=1e-15)
    np.testing.assert_allclose(h.vz, -2.0 * h.t, rtol=1e-11, atol=1e-15)
    np.testing.assert_allclose(h.ratio[h.t > 0.1], 1.0, rtol=1e-11)


@pytest.mark.parametrize(
    ("x", "y", "met"), [(0.9, 0.4, True), (1.1, 0.4, False), (0.9, 0.6, False), (-0.1, 0.1, False)]
)
def test_a_finite_wall_is_missed_beside_its_edges(wall_and, x, y, met):
    """From the corner at the origin 1 along x, and 0.5 along y = z cross x."""
    model = wall_and(ball(x, y) + wall(kind="_FINITE", cards="2.0,0.0,0.0,1.0,0.5\n"), end=0.5)
    h = history(model)
    assert (abs(h.z[-1]) < 1e-14) == met
    assert bool(wall_of(model).impulse[2]) is met


def test_what_comes_from_behind_or_round_an_edge_passes(wall_and):
    late = wall(birth=0.5)
    model = wall_and(ball(z=-0.5, v=(0, 0, 3.0)) + late, end=1.0)
    h = history(model)
    np.testing.assert_allclose(h.z, -0.5 + 3.0 * h.t, atol=1e-13)


def test_a_node_that_slides_off_a_finite_wall_falls(wall_and):
    model = wall_and(
        ball(z=0.0, x=0.5, y=0.2, v=(1.0, 0, 0)) + wall(kind="_FINITE", cards="2.0,0,0,1.0,0.5\n")
        + "*LOAD_BODY_Z\n1,10.0\n",
        end=1.0,
    )  # fmt: skip
    h = history(model)
    assert not h.z[h.x < 1.0].any()
    assert h.z[-1] == pytest.approx(-5.0 * (h.t[-1] - 0.5) ** 2, rel=0.1)


@pytest.mark.parametrize(
    ("kwargs", "met"), [({"birth": 0.3}, True), ({"birth": 0.4}, False), ({"death": 0.3}, False)]
)
def test_a_wall_acts_between_birth_and_death(wall_and, kwargs, met):
    """The ball would reach the wall at t = 1/3."""
    model = wall_and(ball() + wall(**kwargs), end=0.6)
    history(model)
    assert bool(wall_of(model).impulse[2]) is met


def test_a_node_held_until_death_leaves(wall_and):
    model = wall_and(ball(z=0.0, v=(0, 0, 0)) + wall(death=0.5) + "*LOAD_BODY_Z\n1,10.0\n", end=1.0)
    h = history(model)
    assert not h.z[h.t < 0.5].any()
    assert h.z[-1] == pytest.approx(-5.0 * (h.t[-1] - 0.5) ** 2, rel=0.05)


def test_sets_and_offset_choose_the_nodes(wall_and):
    two = ball(nid=5) + ball(nid=6, x=0.5, z=2.0) + "*SET_NODE_LIST\n3\n6\n"
    assert wall_of(wall_and(two + wall())).nodes.tolist() == [4, 5]  # not those of the fixed shell
    assert wall_of(wall_and(two + wall(nsid=3))).nodes.tolist() == [5]
    assert wall_of(wall_and(two + wall(nsidex=3))).nodes.tolist() == [4]
    assert wall_of(wall_and(two + wall(offset=1.5))).nodes.tolist() == [4]


def test_an_oblique_wall_takes_the_normal_momentum_alone(wall_and):
    oblique = "*RIGIDWALL_PLANAR_ID\n7,ramp\n0\n0,0,0,3.0,0,4.0\n"
    model = wall_and(ball(x=0.2, z=0.5) + oblique, end=0.5)
    n = np.array([0.6, 0.0, 0.8])
    for s in steps(model):
        assert (s.x[4] @ n) > -1e-14
    np.testing.assert_allclose(s.v[4], np.array([0, 0, -3.0]) - (-3.0 * 0.8) * n, atol=1e-13)
    assert probe(model, wall=7, component="normal-impulse")() == pytest.approx(2.0 * 3.0 * 0.8, rel=1e-13)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (wall(place=2.0), "NSID = 0: node 5 begins 1 behind the wall"),
        (wall(fric=2.0), "FRIC = 2.0: only 0, 1 and what lies between are supported"),
        (wall(boxid=3), "BOXID = 3: only 0 is supported"),
        (wall(nsid=9), "NSID = 9: no *SET_NODE_... with SID = 9"),
        (wall(birth=2.0, death=1.0), "DEATH = 1.0: the wall would end before its birth at 2"),
        (wall(kind="_MOVING", cards="0.0,1.0\n"), "MASS = 0.0: must be greater than 0"),
        (wall(kind="_MOVING", cards="1.0\n", birth=0.1), "BIRTH = 0.1: not supported for a moving wall"),
        (wall(kind="_FINITE", cards="0,0,2.0,1.0,1.0\n"), "XHEV = 0.0: the edge has no direction across"),
        ("*RIGIDWALL_PLANAR\n0\n1.0,,,1.0\n", "XH = 1.0: the tail and the head of the normal are one point"),
        ("*SET_NODE_LIST\n2\n1,2\n" + wall(nsid=2), "NSID = 2: no node that could meet the wall is free"),
        ("*BOUNDARY_SPC_NODE\n5,0,1\n*RIGIDWALL_PLANAR\n0\n0,0,0,1.0,0,1.0\n", "XH = 1.0: node 5 has a support or prescribed motion oblique"),
        (BODY.format(rwpnal=1.0) + wall(), "RWPNAL = 1.0: the penalty of rigid bodies at rigid walls is not supported"),
        (BODY.format(rwpnal=-1.0) + wall(), "RWPNAL = -1.0: must be at least 0"),
        (wall() + wall(kind="_ID").replace("_ID\n", "_ID\n1,again\n"), "ID = 1: another rigid wall has this number"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(wall_and, text, message):
    with pytest.raises(DeckError) as error:
        wall_and(ball() + text)
    assert message in str(error.value)


def test_order_of_the_options_is_free(wall_and):
    cards = "2.0,0.0,0.0,1.0,0.5\n3.0,0.5\n"
    for kind in ("_FINITE_MOVING", "_MOVING_FINITE"):
        found = wall_of(wall_and(ball() + wall(kind=kind, cards=cards)))
        assert (found.face[4, 0], found.motion[1], found.inverse_mass) == (1.0, 0.5, 1.0 / 3.0)


def test_the_motion_of_a_wall_is_resolved_along_its_normal(wall_and):
    oblique = "*RIGIDWALL_PLANAR_MOVING\n0\n0,0,0,3.0,0,4.0\n2.0,5.0\n"
    model = wall_and(ball() + oblique, end=0.02)
    next(steps(model))
    for component, value in (
        ("normal-velocity", 5.0),
        ("x-velocity", 3.0),
        ("y-velocity", 0.0),
        ("z-velocity", 4.0),
    ):
        assert probe(model, wall=1, component=component)() == pytest.approx(value, rel=1e-15)
    with pytest.raises(ProbeError, match="no 'stress' of a rigid wall; there are: force, impulse"):
        probe(model, wall=1, component="x-stress")
    with pytest.raises(ProbeError, match="no rigid wall 2; there are: 1"):
        probe(model, wall=2, component="x-force")


def test_a_node_in_a_groove_of_two_walls_stays_there(wall_and):
    """Each wall drives the node a little behind the other, and neither loses it; together they carry it."""
    groove = "".join(f"*RIGIDWALL_PLANAR\n0\n0,0,0,{side},0,1.0\n" for side in (3**0.5, -(3**0.5)))
    model = wall_and(ball(x=0.01, z=0.4, v=(0.07, 0, -1.0)) + groove + "*LOAD_BODY_Z\n1,9.81\n", end=5.0)
    show = [probe(model, wall=number, component="z-impulse") for number in (1, 2)]
    deepest = min(s.x[4, 2] for s in steps(model))
    assert deepest > -0.01
    assert abs(model.state.x[4, 2]) < 1e-3
    assert sum(value() for value in show) == pytest.approx(2.0 * (1.0 + 9.81 * model.state.t), rel=1e-3)


def test_momentum_of_many_impacts_is_conserved_to_round_off(wall_and):
    """Random masses and velocities, springs to each other by none: 40 nodes against one moving wall with friction."""
    random = np.random.default_rng(4)
    text = "".join(
        ball(
            *random.uniform(-1, 1, 2), random.uniform(0.1, 1.0), random.uniform(0.5, 2.0),
            (*random.uniform(-2, 2, 2), random.uniform(-3, 0)), nid=10 + i,
        )
        for i in range(40)
    )  # fmt: skip
    model = wall_and(text + wall(fric=0.4, kind="_MOVING", cards="5.0,1.0\n"), end=1.5)
    s, w = model.state, wall_of(model)
    before = s.mass @ s.v
    total = energy.kinetic(s) + w.energy["rigid wall"][0]
    for _ in steps(model):
        pass
    assert math.isclose(5.0 * (w.motion[1] - 1.0), -w.impulse[2], rel_tol=1e-12)
    np.testing.assert_allclose(s.mass @ s.v - before, w.impulse, rtol=1e-12, atol=1e-12)
    assert energy.kinetic(s) + w.energy["rigid wall"][0] == pytest.approx(total, rel=1e-12)


def test_rigid_bodies_pass_through_a_wall_and_that_is_said(wall_and):
    """RWPNAL = 0; neither their nodes nor their centres are stopped."""
    model = wall_and(ball() + BODY.format(rwpnal=0.0) + wall(), end=0.5)
    assert "RWPNAL = 0" in model.facts["Rigid walls and rigid bodies"]
    z = probe(model, rigid=20, component="z-coordinate")
    for s in steps(model):
        assert z() == pytest.approx(0.65 - 3.0 * s.t, abs=1e-12)
    assert abs(s.x[4, 2]) < 1e-14
