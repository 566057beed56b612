"""A rigid motion, instantaneous or over a finite step, of a flat or warped quadrilateral strains nothing."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from vmharness.explicit.elements.shell.belytschko_tsay.strain import increments

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


def corners(a):
    return tuple(map(tuple, a.tolist()))


def rates(x, v, omega, dt):
    _, *parts = increments(corners(x), corners(v), corners(omega), dt)
    return [np.array(part) for part in parts]


def warped(rng):
    return (SQUARE + 0.35 * rng.uniform(-1, 1, (4, 3))) @ Rotation.random(random_state=rng).as_matrix()


def test_rates_vanish_for_any_rigid_velocity():
    rng = np.random.default_rng(1)
    dt = 1e-9  # of a rigid rotation, a finite step turns the nodes by less than the chord says
    for _ in range(500):
        x, v0, w = warped(rng), rng.normal(size=3), rng.normal(size=3)
        membrane, curvature, shear, q, r = rates(x, v0 + np.cross(w, x), np.tile(w, (4, 1)), dt)
        assert np.abs(np.concatenate([membrane / dt, curvature / dt, shear / dt, q, r])).max() < 2e-13


def test_rates_do_not_vanish_when_the_element_deforms():
    rng = np.random.default_rng(2)
    for _ in range(50):
        parts = rates(warped(rng), rng.normal(size=(4, 3)), rng.normal(size=(4, 3)), 1.0)
        assert all(np.abs(part).max() > 1e-3 for part in parts)


@pytest.mark.parametrize("angle", [0.001, 0.02, 0.2, 1.0])
def test_finite_rigid_step(angle):
    """Exact in strain, curvature and hourglass; shear errs by angle s^4 / 5, s = tan(angle / 2)."""
    rng = np.random.default_rng(3)
    dt = 0.01
    for _ in range(100):
        x, axis = warped(rng), rng.normal(size=3)
        turn = angle * axis / np.linalg.norm(axis)
        end = x @ Rotation.from_rotvec(turn).as_matrix().T + rng.normal(size=3)
        v = (end - x) / dt
        membrane, curvature, shear, q, r = rates(end - dt / 2 * v, v, np.tile(turn / dt, (4, 1)), dt)
        assert np.abs(np.concatenate([membrane, curvature, dt * q, dt * r])).max() < 2e-13
        assert np.abs(shear).max() < 1.05 * angle * np.tan(angle / 2) ** 4 / 4 + 2e-13


def test_uniform_velocity_gradients_are_found_in_any_quadrilateral():
    """v_x = 1 + 2x + 3y, v_y = 4x + 5y; omega_x = 6x + 7y, omega_y = 8x + 9y, about the centre."""
    rng = np.random.default_rng(4)
    for _ in range(50):
        x = SQUARE - 0.5
        x[:, :2] += 0.3 * rng.uniform(-1, 1, (4, 2))
        turn = Rotation.from_euler("z", -np.arctan2(*(x[1] - x[0])[1::-1])).as_matrix()
        x = x @ turn.T  # side 1-2 along x
        x[:, 1] -= x[0, 1]
        v = np.stack([1 + 2 * x[:, 0] + 3 * x[:, 1], 4 * x[:, 0] + 5 * x[:, 1], 0 * x[:, 0]], axis=1)
        w = np.stack([6 * x[:, 0] + 7 * x[:, 1], 8 * x[:, 0] + 9 * x[:, 1], 0 * x[:, 0]], axis=1)
        membrane, curvature, shear, q, r = rates(x, v, w, 1.0)
        assert membrane == pytest.approx([2, 5, 7], abs=1e-12)
        assert curvature == pytest.approx([8, -7, 9 - 6], abs=1e-12)
        assert shear == pytest.approx([-w[:, 0].mean(), w[:, 1].mean(), 0], abs=1e-12)
        assert np.abs(np.concatenate([q, r])).max() < 1e-12
