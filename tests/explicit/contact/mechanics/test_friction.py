"""Coulomb friction: stick, slip, decay, limits, energy."""

import numpy as np
import pytest

K, MASS, G = 1000.0, 0.1, 10.0


def strip(scene, bench, v=(0.0, 0.0, 0.0), **options):
    """A node at rest on its penalty, on a strip of ten segments."""
    nodes = scene.sheet(bench.flat, np.linspace(0.0, 10.0, 11), [-1.0, 1.0], mass=0.0)
    ball = scene.nodes([0.05, 0.3, 0.0], v=v, mass=MASS)
    contact = bench.contact((bench.tracked(ball, area=0.5), bench.segments(nodes)), **options)
    return scene.state(), ball[0], contact


def settled(bench, state, ball, contact, dt=1e-4):
    """Lower the node to m g / k without a trace."""
    mass, v = state.mass[ball], state.v[ball].copy()
    state.mass[ball], state.v[ball] = 0.0, [0.0, 0.0, -MASS * G / K / dt]
    for _ in bench.march(state, [contact], dt, 1):
        pass
    state.mass[ball], state.v[ball], state.dt, state.t, state.cycle = mass, v, 0.0, 0.0, 0
    for energy in contact.energy.values():
        energy[:] = 0.0


def test_sliding_across_ten_segments_follows_mu_n(scene, bench):
    # Stops after v^2 / (2 mu g), having lost all its energy to friction.
    v, mu = 7.5, 0.3
    state, ball, contact = strip(scene, bench, v=(v, 0.0, 0.0), fs=mu, fd=mu)
    settled(bench, state, ball, contact)
    crossed = set()
    for s in bench.march(state, [contact], 1e-4, 26000, gravity=(0.0, 0.0, -G)):
        crossed.add(int(contact.passes[0].states["segment"][0, 0]))
        if s.cycle > 50 and s.t < 0.99 * v / mu / G:
            assert -contact.force[0] == pytest.approx(mu * MASS * G, rel=1e-9)
    assert len(crossed) == 10
    assert s.x[ball, 0] - 0.05 == pytest.approx(v**2 / (2.0 * mu * G), rel=1e-3)
    assert contact.energy["friction"][0] == pytest.approx(0.5 * MASS * v**2, rel=1e-3)


def test_a_stick_does_not_creep(scene, bench):
    # 30 degrees with mu just above tan: oscillates on its spring, and is where it was after 10 000 steps.
    angle = np.pi / 6
    state, ball, contact = strip(scene, bench, fs=1.3, fd=1.3)
    settled(bench, state, ball, contact)
    down = G * np.array([0.5 * np.sin(angle), 0.0, -1.0])  # eased on: the oscillation stays within the cone
    places = [s.x[ball, 0] for s in bench.march(state, [contact], 1e-4, 20000, gravity=down)]
    period = int(2.0 * np.pi / np.sqrt(K / MASS) / 1e-4)
    first, last = np.mean(places[: 10 * period]), np.mean(places[-10 * period :])
    assert abs(last - first) < 1e-6
    assert contact.energy["friction"][0] == 0.0


@pytest.mark.parametrize(("fs", "fd", "dc"), [(0.5, 0.2, 0.4), (0.1, 0.3, 2.0)])
def test_friction_decays_with_velocity(scene, bench, fs, fd, dc):
    state, ball, contact = strip(scene, bench, v=(2.0, 0.0, 0.0), fs=fs, fd=fd, dc=dc)
    settled(bench, state, ball, contact)
    for s in bench.march(state, [contact], 1e-4, 3000, gravity=(0.0, 0.0, -G)):
        if s.cycle > 50:
            mu = fd + (fs - fd) * np.exp(-dc * s.v[ball, 0])
            assert -contact.force[0] == pytest.approx(mu * MASS * G, rel=1e-9)


def test_vc_limits_the_shear_stress(scene, bench):
    state, ball, contact = strip(scene, bench, v=(2.0, 0.0, 0.0), fs=0.9, fd=0.9, vc=0.4)
    settled(bench, state, ball, contact)
    for s in bench.march(state, [contact], 1e-4, 1000, gravity=(0.0, 0.0, -G)):
        if s.cycle > 50:
            assert -contact.force[0] == pytest.approx(0.4 * 0.5, rel=1e-9)


def test_what_sticks_turns_with_the_segment(scene, bench):
    # A turntable, whose spring stretches inward by m w^2 r / k: the node goes round with it.
    w, radius = 2.0, 0.5
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
    ball = scene.nodes([radius, 0.0, 0.0], mass=MASS)[0]
    contact = bench.contact((bench.tracked([ball]), bench.segments(nodes)), fs=5.0, fd=5.0)
    state = scene.state()
    settled(bench, state, ball, contact)
    dt = 1e-4
    corners = state.x[:4].copy()

    def spun(t):
        c, s = np.cos(w * t), np.sin(w * t)
        return corners @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])

    def turn(s):
        s.v[:4] = (spun(s.t + dt) - s.x[:4]) / dt

    state.v[:4], state.v[ball] = np.cross([0.0, 0.0, w], corners), [0.0, w * radius, 0.0]
    for s in bench.march(state, [contact], dt, 31416, gravity=(0.0, 0.0, -G), after=turn):
        place, angle = s.x[ball], w * s.t
        assert np.hypot(place[0], place[1]) == pytest.approx(radius, abs=3.0 * MASS * w**2 * radius / K)
    assert contact.energy["friction"][0] == 0.0
    assert np.arctan2(place[1], place[0]) == pytest.approx((angle + np.pi) % (2 * np.pi) - np.pi, abs=1e-3)


def test_the_spring_that_stuck_is_lost_when_a_node_leaves(scene, bench):
    state, ball, contact = strip(scene, bench, fs=10.0, fd=10.0)
    settled(bench, state, ball, contact)
    state.v[ball] = [0.05, 0.0, 0.5]
    before = bench.kinetic(state) + 0.5 * (MASS * G) ** 2 / K
    *_, s = bench.march(state, [contact], 1e-5, 1000)
    assert contact.nodes_in_contact() == 0
    assert contact.energy["friction"][0] > 0.0
    left = contact.energy["contact"][0] + 0.5 * (MASS * G) ** 2 / K
    assert bench.kinetic(s) + contact.energy["friction"][0] + left == pytest.approx(before, rel=1e-5)
    assert left == pytest.approx(0.0, abs=1e-5 * before)
