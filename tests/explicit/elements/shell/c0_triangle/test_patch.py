"""Constant membrane strain and constant curvature are exact in any mesh, with forces on the edge alone."""

import numpy as np
import pytest

X = np.array(
    [[0, 0, 0], [0.24, 0, 0], [0.24, 0.12, 0], [0, 0.12, 0], [0.04, 0.02, 0], [0.18, 0.03, 0], [0.16, 0.08, 0],
     [0.08, 0.08, 0]]
)  # fmt: skip
# MacNeal, Harder (1985): the plate of five quadrilaterals, each cut in two
PATCH = np.array([
    [0, 1, 5], [5, 4, 0], [1, 2, 6], [6, 5, 1], [2, 3, 7], [7, 6, 2], [3, 0, 4], [4, 7, 3], [4, 5, 6], [6, 7, 4]
])  # fmt: skip
INNER, T, E, NU = [4, 5, 6, 7], 0.001, 1e6, 0.25


def in_space(stress, x, nodes):
    """In-plane xx, yy, xy (..., 3) turned from each element's side 1-2 to the x axis."""
    side = x[nodes[:, 1]] - x[nodes[:, 0]]
    c, s = (side / np.linalg.norm(side, axis=1)[:, None]).T[:2, :, None]
    xx, yy, xy = np.moveaxis(stress[..., :3], -1, 0)
    return np.stack(
        [c * c * xx + s * s * yy - 2 * c * s * xy, s * s * xx + c * c * yy + 2 * c * s * xy,
         c * s * (xx - yy) + (c * c - s * s) * xy], axis=-1
    )  # fmt: skip


def test_membrane_patch(bench):
    """u = 1e-3 (x + y/2), v = 1e-3 (y + x/2): stresses 1333.33, 1333.33, 400, and no force inside."""
    block, s = bench.shells(X, PATCH, T, e=E, nu=NU), bench.state(X)
    small = 1e-12  # of that field, so that the response is linear
    s.v[:, 0], s.v[:, 1] = small * 1e-3 * (X[:, 0] + X[:, 1] / 2), small * 1e-3 * (X[:, 1] + X[:, 0] / 2)
    f, moment = bench.internal_forces(block, s)
    stress = in_space(block.stress, X, PATCH) / small
    assert stress == pytest.approx(np.broadcast_to([4000 / 3, 4000 / 3, 400], stress.shape), rel=1e-12)
    assert np.abs(block.stress[..., 3:]).max() == 0
    assert np.abs(f[INNER]).max() < 1e-13 * np.abs(f).max()
    assert np.abs(moment).max() < 1e-13 * np.abs(f).max() * T


def test_bending_patch(bench):
    """w = (x^2 + x y + y^2)/2 1e-3: moments 1.111e-7, 1.111e-7, 0.333e-7, no shear, and no force inside."""
    block, s, small = bench.shells(X, PATCH, T, e=E, nu=NU), bench.state(X), 1e-10
    x, y = X[:, 0], X[:, 1]
    s.v[:, 2] = small * 1e-3 * (x**2 + x * y + y**2) / 2
    s.omega[:, 0], s.omega[:, 1] = small * 1e-3 * (y + x / 2), -small * 1e-3 * (x + y / 2)
    f, moment = bench.internal_forces(block, s)
    z = np.array([-1, 1]) / np.sqrt(3) * T / 2
    M = in_space(np.einsum("p,epc->ec", z * T / 2, block.stress)[:, None], X, PATCH)[:, 0] / small
    expected = np.tile([-1e-6 / 9, -1e-6 / 9, -1e-7 / 3], (10, 1))
    assert pytest.approx(expected, rel=1e-9) == M
    assert np.abs(block.stress[..., 3:]).max() < 1e-10 * np.abs(block.stress).max()
    assert np.abs(moment[INNER]).max() < 1e-9 * np.abs(moment).max()
    assert np.abs(f).max() < 1e-7 * np.abs(moment).max() / 0.1


def test_frequency_of_a_simply_supported_square_plate(bench):
    """omega = 2 (pi/a)^2 sqrt(D / (rho t)), 2 x 16 x 16 triangles of a/t = 100: within 0.5 %."""
    t, n = 0.01, 16
    x, nodes = bench.sheet(n, n, 1.0, 1.0)

    def held(i, k):  # on an edge: w, and the rotation about the normal of the edge
        on_x, on_y = x[i, 0] in (0, 1), x[i, 1] in (0, 1)
        return (k == 2 and (on_x or on_y)) or (k == 3 and on_x) or (k == 4 and on_y)

    free = [(i, k) for i in range(len(x)) for k in (2, 3, 4) if not held(i, k)]
    omega = bench.frequencies(x, nodes, t, free, nip=3, shrf=5 / 6)
    theory = 2 * np.pi**2 * np.sqrt(bench.E * t**2 / (12 * (1 - bench.NU**2) * bench.RHO))
    assert omega[0] == pytest.approx(theory, rel=0.005)
    assert omega[1:4] == pytest.approx(np.array([2.5, 2.5, 4.0]) * theory, rel=0.02)


def test_frequency_of_a_cantilever(bench):
    """omega = (1.875104 / L)^2 sqrt(E t^2 / (12 rho)), nu = 0, 2 x 20 x 2 triangles: within 1 %."""
    t = 0.01
    x, nodes = bench.sheet(20, 2, 1.0, 0.1)
    free = [(i, k) for i in range(len(x)) for k in (2, 3, 4) if x[i, 0] > 0]
    omega = bench.frequencies(x, nodes, t, free, nu=0.0, nip=3)
    assert omega[0] == pytest.approx(1.8751040687**2 * np.sqrt(bench.E * t**2 / (12 * bench.RHO)), rel=0.01)


def test_free_motions_of_one_element(bench):
    """Of its w and rotations in the plane, 5 strain; free are three rigid ones and normals that turn about the centre."""
    x = np.array([[0.0, 0, 0], [1, 0, 0], [0.4, 0.9, 0]])
    nodes = np.array([[0, 1, 2]])
    free = [(i, k) for i in range(3) for k in (2, 3, 4)]
    omega = bench.frequencies(x, nodes, 0.1, free)
    assert omega[3] < 1e-3 * omega[4]
    block, s = bench.shells(x, nodes, 0.1), bench.state(x)
    s.omega[:, :2] = 1e-9 * (x - x.mean(axis=0))[:, :2]
    bench.internal_forces(block, s)
    assert np.abs(block.stress).max() < 1e-12 * 1e-9 * bench.E


def test_a_sheet_has_no_free_motion_but_rigid_ones(bench):
    x, nodes = bench.sheet(2, 2, 1.0, 1.0)
    omega = bench.frequencies(x, nodes, 0.1, [(i, k) for i in range(len(x)) for k in (2, 3, 4)])
    assert omega[2] < 1e-5 * omega[-1]
    assert omega[3] > 1e-2 * omega[-1]
