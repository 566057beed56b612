"""Two-way and single-surface contact; piles; what is there at the start."""

import itertools

import numpy as np
import pytest

from vmharness.explicit.contact.initial_penetration import initial_penetrations
from vmharness.explicit.state import Array


class Springs:
    """Straight springs between nodes, each of stiffness k, that hold a body together."""

    def __init__(self, x: Array, pairs: Array, k: float) -> None:
        self.i, self.j = np.array(pairs).T
        self.length = np.linalg.norm(x[self.i] - x[self.j], axis=1)
        self.k, self.stored = k, 0.0

    def add(self, s) -> None:
        apart = s.x[self.j] - s.x[self.i]
        length = np.linalg.norm(apart, axis=1)
        pull = (self.k * (length - self.length) / length)[:, None] * apart
        np.add.at(s.f, self.i, pull)
        np.add.at(s.f, self.j, -pull)
        self.stored = float(0.5 * self.k * ((length - self.length) ** 2).sum())


FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
CUBE = np.array(
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float
)


def block(scene, at, v=(0.0, 0.0, 0.0), turn=None):
    """Faces (6, 4), outward, and springs of all edges and diagonals of a unit cube."""
    corners = CUBE - 0.5
    rows = scene.nodes((corners @ turn if turn is not None else corners) + np.asarray(at), v=v, mass=0.125)
    return rows[FACES], [(rows[i], rows[j]) for i, j in itertools.combinations(range(8), 2)]


def turned(rng):
    """A random rotation."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    q[:, 0] *= np.linalg.det(q)
    return q


def test_a_symmetric_two_way_impact_is_symmetric(scene, bench):
    # Two equal sheets, mirror images in z = 0, bent so that they meet in the middle.
    def shape(sign):
        return lambda a, b: (a, b, sign * (0.02 + 0.3 * (a * a + b * b)))

    grid = np.linspace(-0.5, 0.5, 6)
    low = scene.sheet(shape(-1.0), grid, grid, v=[0.0, 0.0, 1.0], mass=0.02)
    high = scene.sheet(shape(1.0), grid, grid, v=[0.0, 0.0, -1.0], mass=0.02)[:, ::-1]
    state = scene.state()
    one = (bench.tracked(np.unique(low)), bench.segments(high))
    two = (bench.tracked(np.unique(high)), bench.segments(low))
    contact, touched, n = bench.contact(one, two), False, 36
    for s in bench.march(state, [contact], 1e-4, 2000):
        touched |= contact.nodes_in_contact() > 0
        np.testing.assert_allclose(s.x[:n, :2], s.x[n:, :2], atol=1e-12)
        np.testing.assert_allclose(s.x[:n, 2], -s.x[n:, 2], atol=1e-12)
    assert touched
    assert contact.force == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)
    np.testing.assert_allclose(bench.kinetic(s), 0.5 * 0.02 * 72, rtol=1e-2)


def test_a_block_on_a_block_of_the_same_size_does_not_slip_off(scene, bench):
    # Node on node, edge on edge: the upper one rests where it is set down.
    floor, _ = block(scene, [0.0, 0.0, -0.5])
    scene.mass[:] = [0.0] * 8
    upper, own = block(scene, [0.0, 0.0, 0.5])
    state = scene.state()
    sides = [(bench.tracked(np.unique(a)), bench.segments(b)) for a, b in ((upper, floor), (floor, upper))]
    contact = bench.contact(*sides, vdc=20.0)
    forces = [contact, Springs(state.x, own, 500.0)]
    *_, s = bench.march(state, forces, 1e-3, 5000, gravity=(0.0, 0.0, -1.0))
    assert contact.nodes_in_contact() == 8
    # m g over four nodes; of each, two springs of 1000.
    np.testing.assert_allclose(s.x[np.unique(upper)[:4], 2], -0.25 / 2000.0, rtol=0.05)
    np.testing.assert_allclose(s.x[8:, :2], CUBE[:, :2] - 0.5, atol=1e-3)


def test_a_folding_strip_touches_itself(scene, bench):
    # A strip bent to a hairpin closes with 1 unit of speed: its legs stop at the thickness, and open again.
    def hairpin(a, b):
        angle = np.clip(a, -0.5, 0.5) * np.pi
        along = max(abs(a) - 0.5, 0.0)
        return -along + 0.3 * np.cos(angle), b, 0.3 * np.sin(angle)

    grid = np.concatenate([np.linspace(-2.5, -0.5, 9), np.linspace(-0.4, 0.4, 7), np.linspace(0.5, 2.5, 9)])
    strip = scene.sheet(hairpin, grid, [-0.2, 0.2], mass=0.01)
    state = scene.state()
    rows, thickness = np.unique(strip), 0.04
    state.v[rows, 2] = -np.sign(state.x[rows, 2]) * (state.x[rows, 0] < 0.0)
    sides = (
        bench.tracked(rows, thickness=thickness),
        bench.segments(strip, thickness=thickness, two_sided=True),
    )
    contact = bench.contact(sides)
    assert initial_penetrations(contact, state.x) == []
    before, legs = bench.kinetic(state), rows[state.x[rows, 0] < -0.2]
    upper = legs[state.x[legs, 2] > 0.0]
    least = np.inf
    for s in bench.march(state, [contact], 1e-4, 5000):
        least = min(least, s.x[upper, 2].min())
        np.testing.assert_allclose(s.f.sum(axis=0), 0.0, atol=1e-10)
    assert 0.0 < 2.0 * least < thickness
    assert bench.kinetic(s) == pytest.approx(before, rel=1e-2)
    assert (s.v[upper, 2] > 0.5).all()


def test_momentum_of_a_pile_is_kept_through_ten_thousand_impacts(scene, bench):
    # Spinning blocks, drawn together by soft springs, knock about in one single surface without walls.
    rng = np.random.default_rng(4)
    faces, beams, marks = [], [], []
    for cell in itertools.product(range(3), repeat=3):
        place = 2.0 * (np.array(cell) - 1.0)
        own, springs = block(scene, place, v=rng.uniform(-1.0, 1.0, 3), turn=turned(rng))
        faces.append(own)
        beams.extend(springs)
        marks.append(own[0, 0])
    nodes, state = np.concatenate(faces), scene.state()
    contact = bench.contact((bench.tracked(np.unique(nodes)), bench.segments(nodes, penalty=2000.0)))
    body = Springs(state.x, beams, 500.0)
    pull = Springs(state.x, list(itertools.combinations(marks, 2)), 0.5)
    pull.length *= 0.1
    momentum = (state.mass[:, None] * state.v).sum(axis=0)
    moment = np.cross(state.x, state.mass[:, None] * state.v).sum(axis=0)
    size = (state.mass[:, None] * np.abs(state.v)).sum()
    pull.add(state)
    before, onsets, held = bench.kinetic(state) + pull.stored, 0, np.zeros(216, bool)
    for _ in bench.march(state, [contact, body, pull], 1e-3, 20000):
        now = contact.forces.any(axis=1)
        onsets, held = onsets + int((now & ~held).sum()), now
    assert onsets > 10_000
    now = state.mass[:, None] * bench.velocity(state)
    np.testing.assert_allclose(now.sum(axis=0), momentum, atol=1e-10 * size)
    np.testing.assert_allclose(np.cross(state.x, now).sum(axis=0), moment, atol=1e-10 * size)
    account = {name: value[0] for name, value in contact.energy.items()}
    total = bench.kinetic(state) + body.stored + pull.stored + sum(account.values())
    assert total == pytest.approx(before, rel=5e-3)
    assert account["released"] > 0.1 * before  # at sharp edges, by nodes deep behind them
    assert abs(account["contact"]) < 0.02 * before  # a few touch, and the error of thousands of impacts


@pytest.mark.parametrize("ignore", [False, True])
@pytest.mark.parametrize("two_sided", [False, True])
def test_initial_penetrations_are_reported_and_kept_as_offsets_if_asked(scene, bench, two_sided, ignore):
    nodes = scene.sheet(bench.flat, np.linspace(-1, 1, 5), np.linspace(-1, 1, 5), mass=0.0)
    depth, half = 0.01, 0.05 * two_sided
    ball = scene.nodes([0.1, 0.2, half - depth], mass=0.1)
    sides = (bench.tracked(ball), bench.segments(nodes, thickness=2.0 * half, two_sided=two_sided))
    contact = bench.contact(sides, ignore=ignore)
    state = scene.state()
    ((row, way),) = initial_penetrations(contact, state.x)
    assert row == ball[0]
    np.testing.assert_allclose(way, [0.0, 0.0, depth], atol=1e-12)
    if ignore:  # no force but for what goes deeper
        state.v[ball] = [0.0, 0.0, -1.0]
        for s in bench.march(state, [contact], 1e-4, 50):
            assert contact.force[2] == pytest.approx(1000.0 * (half - depth - s.x[ball[0], 2]))


def test_soft_1_takes_the_stiffness_that_the_step_allows(scene, bench):
    nodes = scene.sheet(bench.flat, [-1.0, 1.0], [-1.0, 1.0], mass=0.4)
    ball = scene.nodes([0.0, 0.0, 0.0], v=[0.0, 0.0, -1.0], mass=0.2)
    weak = (bench.tracked(ball), bench.segments(nodes, penalty=1e-3))
    contact, dt = bench.contact(weak, soft=1, sofscl=0.1), 1e-3
    for _ in bench.march(scene.state(), [contact], dt, 1):
        pass
    assert contact.force[2] == pytest.approx(0.1 * 0.2 / dt**2 * dt, rel=1e-9)
