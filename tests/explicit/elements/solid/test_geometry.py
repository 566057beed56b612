"""Volume, gradients and sides in patterns, against integration in the ordinary way."""

import numpy as np
import pytest
from scipy.optimize import approx_fprime

from vmharness.explicit.elements.solid._gradient import at_point, largest_face, mean, measures
from vmharness.explicit.elements.solid._pattern import nodal, patterns

CUBE = np.array([
    [-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1],
], float)  # fmt: skip
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(3)


def vectors(a):
    return tuple(map(tuple, a.tolist()))


def distorted(seed):
    return CUBE + 0.5 * np.random.default_rng(seed).uniform(-1, 1, (8, 3))


def shape_derivatives(p):
    """dN_I/dxi_j (8, 3) of the trilinear element."""
    factors = 1 + CUBE * p
    return np.stack(
        [CUBE[:, j] * factors[:, (j + 1) % 3] * factors[:, (j + 2) % 3] / 8 for j in range(3)], axis=1
    )


def integrated(x):
    """V and the mean of dN_I/dx, by 3 x 3 x 3 points."""
    volume, B = 0.0, np.zeros((8, 3))
    for i, j, k in np.ndindex(3, 3, 3):
        dN = shape_derivatives(POINTS[[i, j, k]])
        J = x.T @ dN
        weight = WEIGHTS[i] * WEIGHTS[j] * WEIGHTS[k] * np.linalg.det(J)
        volume, B = volume + weight, B + weight * dN @ np.linalg.inv(J)
    return volume, B / volume


@pytest.mark.parametrize("seed", range(5))
def test_volume_and_mean_gradient(seed):
    x, phi = distorted(seed), np.random.default_rng(100 + seed).normal(size=(8, 3))
    volume, B = integrated(x)
    V, b = mean(patterns(vectors(x)))
    assert pytest.approx(volume, rel=1e-13) == V
    gradient = sum(np.outer(p, q) for p, q in zip(patterns(vectors(phi))[:6], b, strict=True)) / V
    assert gradient == pytest.approx(phi.T @ B, rel=1e-12, abs=1e-13)
    assert measures(np.array([x]))[0] == pytest.approx([volume], rel=1e-13)


def test_mean_gradient_is_the_derivative_of_the_volume():
    x = distorted(7)
    slope = approx_fprime(x.ravel(), lambda y: measures(y.reshape(1, 8, 3))[0][0], 1e-6).reshape(8, 3)
    _, b = mean(patterns(vectors(x)))
    assert np.array(nodal((*b, (0.0, 0.0, 0.0)))) == pytest.approx(slope, abs=1e-5)


def test_gradient_at_a_point():
    x, phi, p = distorted(8), np.random.default_rng(8).normal(size=(8, 3)), np.array([0.3, -0.5, 0.7])
    J = x.T @ shape_derivatives(p)
    j, b = at_point(patterns(vectors(x)), *p)
    assert j == pytest.approx(np.linalg.det(J))
    gradient = sum(np.outer(q, r) for q, r in zip(patterns(vectors(phi)), b, strict=True)) / j
    assert gradient == pytest.approx(phi.T @ shape_derivatives(p) @ np.linalg.inv(J))


def test_largest_side():
    x = distorted(9)
    sides = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    areas = [0.5 * np.linalg.norm(np.cross(x[c] - x[a], x[d] - x[b])) for a, b, c, d in sides]
    assert largest_face(patterns(vectors(x))) == pytest.approx(max(areas))


def test_power_is_the_same_in_patterns_and_at_nodes():
    rng = np.random.default_rng(10)
    v, f = rng.normal(size=(8, 3)), rng.normal(size=(7, 3))
    power = np.sum(np.array(patterns(vectors(v))) * f)
    assert np.sum(v * np.array(nodal(vectors(f)))) == pytest.approx(power)


def test_wedge():
    """Half a box: the fifth and sixth node stand twice."""
    x = np.array([[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0], [0, 0, 1], [0, 0, 1], [0, 3, 1], [0, 3, 1.0]])
    assert measures(x[None])[0] == pytest.approx([3.0], rel=1e-15)
