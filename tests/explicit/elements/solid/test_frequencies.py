"""Frequencies and waves against theory."""

import numpy as np
import pytest
from scipy.linalg import eigh

from vmharness.explicit.elements.solid.one_point import Hourglass


def first_frequency(bench, x, nodes, free, elform, control, nu):
    block = bench.solids(x, nodes, elform, control, nu=nu)
    K = bench.stiffness(block, x, free)
    assert np.abs(K - K.T).max() < 1e-8 * np.abs(K).max()
    root = np.sqrt(bench.lumped(x, nodes)[[i for i, _ in free], 0])
    scaled = K / np.outer(root, root)
    return np.sqrt(eigh((scaled + scaled.T) / 2, eigvals_only=True, subset_by_index=[0, 0])[0])


@pytest.mark.parametrize(
    ("elform", "control", "cells", "tolerance"),
    [
        (2, None, (20, 2, 2), 0.01),
        (1, Hourglass(ihq=4, qm=0.165), (20, 2, 2), 0.015),
        (1, Hourglass(ihq=4, qm=0.1), (20, 2, 2), 0.06),
    ],
)
def test_cantilever(bench, elform, control, cells, tolerance):
    """omega = (1.875104 / L)^2 sqrt(E h^2 / (12 rho)), 10 x 1 x 1, less 0.5 % for shear and rotary inertia (Timoshenko)."""
    length, h, nu = 10.0, 1.0, 0.3
    x, nodes = bench.boxes(*cells, length, h, h)
    free = [(i, k) for i in range(len(x)) for k in range(3) if x[i, 0] > 0]
    omega = first_frequency(bench, x, nodes, free, elform, control, nu)
    theory = (1.8751040687 / length) ** 2 * np.sqrt(bench.E * h**2 / (12 * bench.RHO))
    assert omega == pytest.approx(0.995 * theory, rel=tolerance)


@pytest.mark.parametrize(("elform", "nu"), [(1, 0.3), (2, 0.3), (2, 0.499)])
def test_thickness_vibration_runs_at_the_dilatational_speed(bench, elform, nu):
    """A column free at both ends, sides held: omega = pi c_L / L, nearly incompressible too."""
    n = 40
    x, nodes = bench.boxes(n, 1, 1, 1.0, 1 / n, 1 / n)
    block = bench.solids(x, nodes, elform, nu=nu)
    K = bench.stiffness(block, x, [(i, 0) for i in range(len(x))])
    planes = np.kron(np.eye(n + 1), np.ones((4, 1)))  # the four nodes of a plane move as one
    mass = planes.T @ bench.lumped(x, nodes)[:, 0]
    scaled = planes.T @ K @ planes / np.sqrt(np.outer(mass, mass))
    rigid, first = eigh((scaled + scaled.T) / 2, eigvals_only=True, subset_by_index=[0, 1])
    c = np.sqrt(bench.E * (1 - nu) / ((1 + nu) * (1 - 2 * nu) * bench.RHO))
    assert abs(rigid) < 1e-6 * first
    found = np.sqrt(first)
    assert found == pytest.approx(
        2 * n * c * np.sin(np.pi / (2 * n)), rel=1e-6
    )  # of lumped masses: pi c (1 - 2.6e-4)


@pytest.mark.parametrize("nu", [0.3, 0.4999])
def test_full_integration_does_not_lock_at_constant_volume(bench, nu):
    """A cantilever 6 x 1 x 1 of cubes with side 1/2, less 1.3 % for shear and rotary inertia (Timoshenko)."""
    x, nodes = bench.boxes(12, 2, 2, 6.0, 1.0, 1.0)
    free = [(i, k) for i in range(len(x)) for k in range(3) if x[i, 0] > 0]
    omega = first_frequency(bench, x, nodes, free, 2, None, nu)
    theory = (1.8751040687 / 6) ** 2 * np.sqrt(bench.E / (12 * bench.RHO))
    assert omega == pytest.approx(0.987 * theory, rel=0.04)
