"""Forces, moments, momentum and energy of whole impacts."""

import numpy as np
import pytest


def bumpy(a, b):
    return a, b, 0.05 * np.sin(3.0 * a) * np.cos(4.0 * b)


def impact(scene, bench, **options):
    """A handful of nodes thrown on a bumpy sheet of free nodes."""
    rng = np.random.default_rng(2)
    nodes = scene.sheet(bumpy, np.linspace(-1, 1, 6), np.linspace(-1, 1, 6), mass=0.02)
    balls = scene.nodes(
        np.column_stack([rng.uniform(-0.7, 0.7, (5, 2)), np.full(5, 0.08)]), v=[0.3, -0.2, -1.0], mass=0.05
    )
    return scene.state(), balls, bench.contact((bench.tracked(balls), bench.segments(nodes)), **options)


@pytest.mark.parametrize("options", [{}, {"fs": 0.4, "fd": 0.2, "dc": 1.0}, {"vdc": 20.0}])
def test_forces_and_moments_balance(scene, bench, options):
    state, _, contact = impact(scene, bench, **options)
    touched = 0
    for s in bench.march(state, [contact], 2e-4, 2000):
        size = np.abs(s.f).sum()
        touched += bool(size)
        np.testing.assert_allclose(s.f.sum(axis=0), 0.0, atol=1e-14 * size + 1e-300)
        moment, arm = np.cross(s.x, s.f).sum(axis=0), np.abs(s.x).max()
        np.testing.assert_allclose(moment, 0.0, atol=1e-13 * size * arm + 1e-300)
    assert touched > 50


def test_frictionless_contact_gives_its_energy_back(scene, bench):
    state, _, contact = impact(scene, bench)
    before, most, worst = bench.kinetic(state), 0.0, 0.0
    for s in bench.march(state, [contact], 2e-4, 3000):
        most = max(most, contact.energy["contact"][0])
        worst = max(worst, abs(bench.kinetic(s) + contact.energy["contact"][0] - before))
    assert contact.nodes_in_contact() == 0
    assert most > 0.1 * before
    assert abs(contact.energy["contact"][0]) < 2e-3 * most  # (w dt)^2
    assert worst < 1e-3 * before
    assert contact.energy["friction"][0] == 0.0


def test_friction_and_damping_account_for_all_energy(scene, bench):
    state, _, contact = impact(scene, bench, fs=0.3, fd=0.3, vdc=10.0)
    before = bench.kinetic(state)
    for s in bench.march(state, [contact], 2e-4, 3000):
        account = contact.energy["contact"][0] + contact.energy["friction"][0]
        assert bench.kinetic(s) + account == pytest.approx(before, rel=1e-4)
    assert contact.energy["friction"][0] > 0.01 * before
    assert contact.energy["contact"][0] > 0.01 * before  # what damping took


@pytest.mark.parametrize(
    ("v", "release", "death"),
    [((0.0, 0.0, -1.0), 0.004, 1e20), ((1.0, 0.0, -0.1), np.inf, 1e20), ((0.0, 0.0, -1.0), np.inf, 0.0074)],
    ids=["too deep", "beyond the end", "at death"],
)
@pytest.mark.parametrize("options", [{}, {"fs": 0.3, "fd": 0.3}])
def test_what_is_let_go_while_it_is_pressed_leaves_nothing_stored(scene, bench, v, release, death, options):
    # The sheet is held, and ends at x = 1; a quarter of the oscillation on it takes 0.011.
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
    ball = scene.nodes([0.996, 0.0, 0.0], v=v, mass=0.05)
    sides = bench.tracked(ball), bench.segments(nodes, release=release)
    contact = bench.contact(sides, dt=death, **options, maxpar=1.0)
    state, most = scene.state(), 0.0
    before = bench.kinetic(state)
    for s in bench.march(state, [contact], 1e-4, 150):
        account = {name: value[0] for name, value in contact.energy.items()}
        total = bench.kinetic(s) + sum(account.values())
        assert total == pytest.approx(before, rel=1e-4)  # (w dt)^2
        most = max(most, account["contact"])
    assert not contact.force.any()
    assert contact.nodes_in_contact() == 0
    assert total == pytest.approx(before, rel=1e-12)
    assert account["released"] == pytest.approx(most, rel=0.1)
    assert account["contact"] == pytest.approx(0.0, abs=1e-12)


def test_what_is_pressed_as_a_contact_is_born_was_given_by_nothing(scene, bench):
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
    ball = scene.nodes([0.1, 0.2, 0.03], v=[0.0, 0.0, -1.0], mass=0.1)
    segments = bench.segments(nodes, thickness=0.05, two_sided=True)
    contact = bench.contact((bench.tracked(ball, thickness=0.05), segments), bt=0.00995)
    state = scene.state()
    for s in bench.march(state, [contact], 1e-4, 500):
        if s.cycle == 100:  # the first with force, where the depth is 0.03
            assert contact.energy["contact"][0] == pytest.approx(0.5 * 1000.0 * 0.03**2, rel=1e-9)
    assert contact.nodes_in_contact() == 0
    assert contact.energy["contact"][0] == pytest.approx(0.0, abs=2e-3 * 0.45)
    gained = bench.kinetic(s) - 0.5 * 0.1
    assert contact.energy["released"][0] == pytest.approx(-gained, rel=2e-3)
    assert gained == pytest.approx(0.45, rel=1e-2)


@pytest.mark.parametrize("steps", [100])
def test_the_order_of_the_smooth_phase_is_two(scene, bench, steps):
    # A quarter of the oscillation on the contact's spring, w = sqrt(k/m): depth v/w at its end.
    errors = []
    for n in (steps, 2 * steps):
        own = type(scene)()
        nodes = own.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
        ball = own.nodes([0.1, 0.2, 0.0], v=[0.0, 0.0, -1.0], mass=0.1)
        contact = bench.contact((bench.tracked(ball), bench.segments(nodes)))
        w = 100.0
        *_, s = bench.march(own.state(), [contact], 0.5 * np.pi / w / n, n)
        errors.append(abs(-s.x[ball[0], 2] - 1.0 / w))
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)


@pytest.mark.parametrize(("z", "restitution"), [(0.05, 0.858758), (0.1, 0.744079), (0.2, 0.571740)])
def test_damping_releases_at_zero_force(scene, bench, z, restitution):
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.0)
    ball = scene.nodes([0.1, 0.2, 0.0], v=[0.0, 0.0, -1.0], mass=0.1)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes)), vdc=100.0 * z)
    state = scene.state()
    for _ in bench.march(state, [contact], 1e-5, 5000):
        assert contact.force[2] >= 0.0
    assert state.v[ball[0], 2] == pytest.approx(restitution, rel=3e-4)


def test_damping_of_two_masses_is_a_fraction_of_critical(scene, bench):
    # Each corner has the ball's mass: m_m = 1/4 of 4 of them, mu = m/2, c/(2 mu w) = 2 z.
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.1)
    ball = scene.nodes([0.0, 0.0, 0.0], v=[0.0, 0.0, -1.0], mass=0.1)
    contact = bench.contact((bench.tracked(ball), bench.segments(nodes)), vdc=5.0)
    for _ in bench.march(scene.state(), [contact], 1e-6, 1):
        pass
    w = np.sqrt(1000.0 * 2.0 / 0.1)
    assert contact.force[2] == pytest.approx(0.05 * 2.0 * 0.1 * w, rel=1e-3)
