"""Nodal forces are the transpose of the rates: they do the resultants' work, and balance."""

import numpy as np
import pytest

from vmharness.explicit.elements.shell.belytschko_tsay.strain import increments, nodal_forces

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


def corners(a):
    return tuple(map(tuple, a.tolist()))


def random_case(rng):
    x = SQUARE + 0.35 * rng.uniform(-1, 1, (4, 3))
    N, M, S, Q, R = rng.normal(size=(5, 3))
    S[2] = R[2] = 0.0
    f, moment = nodal_forces(corners(x), tuple(N), tuple(M), tuple(S), tuple(Q), tuple(R))
    return x, (N, M, S, Q, R), np.array(f), np.array(moment)


def test_power_of_nodal_forces_is_that_of_the_resultants():
    """f . v + m . omega = A (N . d + M . k + S . gamma) + Q . q + R . r, for any velocity of any quadrilateral."""
    rng = np.random.default_rng(1)
    for _ in range(200):
        x, (N, M, S, Q, R), f, moment = random_case(rng)
        v, omega = rng.normal(size=(2, 4, 3))
        area, *_, q, r = increments(corners(x), corners(v), corners(omega), 0.0)
        dt = 1e-9  # rates at this geometry
        _, membrane, curvature, shear, *_ = increments(corners(x), corners(v), corners(omega), dt)
        inner = area / dt * (N @ membrane + M @ curvature + S @ shear) + Q @ q + R @ r
        assert np.sum(f * v) + np.sum(moment * omega) == pytest.approx(inner, rel=1e-12, abs=1e-12)


def test_forces_and_moments_balance_on_warped_elements():
    rng = np.random.default_rng(2)
    for _ in range(200):
        x, _, f, moment = random_case(rng)
        assert np.abs(f.sum(axis=0)).max() < 1e-13
        assert np.abs((np.cross(x, f) + moment).sum(axis=0)).max() < 2e-13


def test_force_is_the_gradient_of_the_energy(bench):
    """f = dU/dx by central differences about a strained flat element, stiffness hourglass included."""
    rng = np.random.default_rng(3)
    x = SQUARE + 0.2 * np.pad(rng.uniform(-1, 1, (4, 2)), ((0, 0), (0, 1)))
    nodes = np.array([[0, 1, 2, 3]])
    control = bench.hourglass(ihq=4)
    u = 1e-6 * rng.normal(size=(4, 6))

    def moved(u):
        block, s = bench.shells(x, nodes, 0.1, nip=3, shrf=5 / 6, hourglass=control), bench.state(x)
        s.v[:], s.omega[:] = u[:, :3], u[:, 3:]
        s.x += s.v
        f = np.hstack(bench.internal_forces(block, s))
        return f, block.energy["internal"][0] + block.energy["hourglass"][0]

    f, _ = moved(u)
    for i, k in np.ndindex(4, 6):
        d = np.zeros((4, 6))
        d[i, k] = 1e-6
        slope = (moved(u + d)[1] - moved(u - d)[1]) / 2e-6
        assert slope == pytest.approx(f[i, k], abs=1e-5 * np.abs(f).max())
