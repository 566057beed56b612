"""Rigid motion strains nothing; nodal forces are the transpose of the rates, do the resultants' work, and balance."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from vmharness.explicit.elements.shell.c0_triangle.strain import increments, nodal_forces

TRIANGLE = np.array([[0.0, 0, 0], [1, 0, 0], [0.4, 0.9, 0]])


def corners(a):
    return tuple(map(tuple, a.tolist()))


def rates(x, v, omega, dt):
    _, *parts = increments(corners(x), corners(v), corners(omega), dt)
    return np.array(parts)


def some(rng):
    return (TRIANGLE + 0.3 * rng.uniform(-1, 1, (3, 3))) @ Rotation.random(random_state=rng).as_matrix()


def test_rates_vanish_for_any_rigid_velocity():
    rng = np.random.default_rng(1)
    dt = 1e-9  # of a rigid rotation, a finite step turns the nodes by less than the chord says
    for _ in range(300):
        x, v0, w = some(rng), rng.normal(size=3), rng.normal(size=3)
        assert np.abs(rates(x, v0 + np.cross(w, x), np.tile(w, (3, 1)), dt) / dt).max() < 2e-12
        assert (
            np.abs(rates(x, rng.normal(size=(3, 3)), rng.normal(size=(3, 3)), 1.0)).max(axis=1).min() > 1e-3
        )


@pytest.mark.parametrize("angle", [0.001, 0.02, 0.2, 1.0])
def test_finite_rigid_step(angle):
    """Exact in strain and curvature; shear errs by angle s^4 / 5, s = tan(angle / 2)."""
    rng = np.random.default_rng(3)
    dt = 0.01
    for _ in range(100):
        x, axis = some(rng), rng.normal(size=3)
        turn = angle * axis / np.linalg.norm(axis)
        end = x @ Rotation.from_rotvec(turn).as_matrix().T + rng.normal(size=3)
        v = (end - x) / dt
        membrane, curvature, shear = rates(end - dt / 2 * v, v, np.tile(turn / dt, (3, 1)), dt)
        assert np.abs([membrane, curvature]).max() < 1e-12
        assert np.abs(shear).max() < 1.05 * angle * np.tan(angle / 2) ** 4 / 4 + 1e-12


def test_side_means_of_the_shear_give_that_of_the_centre():
    """(a - c y, b + c x), fitted to the mean tangential shear of each side, taken at the centre."""
    rng = np.random.default_rng(4)
    for _ in range(50):
        x = TRIANGLE + np.pad(0.3 * rng.uniform(-1, 1, (3, 2)), ((0, 0), (0, 1)))
        side = x[1] - x[0]
        x = (x - x.mean(axis=0)) @ Rotation.from_euler("z", -np.arctan2(side[1], side[0])).as_matrix().T
        v, w = rng.normal(size=(2, 3, 3))
        beta = np.stack([w[:, 1], -w[:, 0]], axis=1)
        rows, means = [], []
        for i, j in ((0, 1), (1, 2), (2, 0)):
            t, middle = (x[j] - x[i])[:2], (x[i] + x[j])[:2] / 2
            rows.append([*t, t[1] * middle[0] - t[0] * middle[1]])
            means.append(v[j, 2] - v[i, 2] + t @ (beta[i] + beta[j]) / 2)
        zx, yz, _ = np.linalg.solve(rows, means)
        dt = 1e-9
        assert rates(x, v, w, dt)[2] / dt == pytest.approx([yz, zx, 0], abs=1e-12)


def test_power_of_nodal_forces_is_that_of_the_resultants_and_they_balance():
    rng = np.random.default_rng(1)
    for _ in range(200):
        x, (N, M, S) = some(rng), rng.normal(size=(3, 3))
        S[2] = 0.0
        f, moment = map(np.array, nodal_forces(corners(x), tuple(N), tuple(M), tuple(S)))
        v, omega = rng.normal(size=(2, 3, 3))
        dt = 1e-9
        area, *parts = increments(corners(x), corners(v), corners(omega), dt)
        inner = area / dt * sum(np.dot(a, b) for a, b in zip((N, M, S), parts, strict=True))
        assert np.sum(f * v) + np.sum(moment * omega) == pytest.approx(inner, rel=1e-9, abs=1e-9)
        assert np.abs(f.sum(axis=0)).max() < 1e-12
        assert np.abs((np.cross(x, f) + moment).sum(axis=0)).max() < 1e-11


@pytest.mark.parametrize("axis", [(0, 0, 1), (1, 0, 0), (1, 2, -2)])
def test_full_turn_in_steps_of_one_degree(bench, axis):
    """The stress stays in the element's frame, and its forces turn with it."""
    x = TRIANGLE
    block = bench.shells(x, np.array([[0, 1, 2]]), 0.05)
    prestress = 1e-3 * bench.E * np.array([[[1.0, -0.4, 0.3, 0.2, -0.1], [0.5, 0.7, -0.6, 0.2, -0.1]]])
    block.stress = prestress
    s = bench.state(x)
    s.dt = 0.0
    f0, moment0 = bench.internal_forces(block, s)
    s.dt = 0.01
    turn = np.radians(1.0) * np.array(axis) / np.linalg.norm(axis)
    for n in range(1, 361):
        R = Rotation.from_rotvec(n * turn).as_matrix()
        s.v[:], s.omega[:] = (x @ R.T - s.x) / s.dt, turn / s.dt
        s.x[:] = x @ R.T
        f, moment = bench.internal_forces(block, s)
        if n == 77:
            assert f == pytest.approx(f0 @ R.T, abs=1e-5 * np.abs(f0).max())
            assert moment == pytest.approx(moment0 @ R.T, abs=1e-5 * np.abs(moment0).max())
    assert np.abs(block.stress - prestress).max() < 1e-8 * bench.E


def test_force_is_the_gradient_of_the_energy(bench):
    rng = np.random.default_rng(3)
    u = 1e-6 * rng.normal(size=(3, 6))

    def moved(u):
        block, s = (
            bench.shells(TRIANGLE, np.array([[0, 1, 2]]), 0.1, nip=3, shrf=5 / 6),
            bench.state(TRIANGLE),
        )
        s.v[:], s.omega[:] = u[:, :3], u[:, 3:]
        s.x += s.v
        return np.hstack(bench.internal_forces(block, s)), block.energy["internal"][0]

    f, _ = moved(u)
    for i, k in np.ndindex(3, 6):
        d = np.zeros((3, 6))
        d[i, k] = 1e-6
        slope = (moved(u + d)[1] - moved(u - d)[1]) / 2e-6
        assert slope == pytest.approx(f[i, k], abs=1e-5 * np.abs(f).max())
