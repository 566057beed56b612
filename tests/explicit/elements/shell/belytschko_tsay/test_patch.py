"""Constant states: which the element has exactly, and which not."""

import numpy as np
import pytest

from vmharness.explicit.elements.shell.belytschko_tsay import Hourglass

# MacNeal, Harder (1985): a 0.24 x 0.12 plate of five quadrilaterals
X = np.array(
    [
        [0, 0, 0], [0.24, 0, 0], [0.24, 0.12, 0], [0, 0.12, 0],
        [0.04, 0.02, 0], [0.18, 0.03, 0], [0.16, 0.08, 0], [0.08, 0.08, 0],
    ]
)  # fmt: skip
PATCH = np.array([[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]])
INNER = [4, 5, 6, 7]
THICKNESS = 0.001


def global_stress(block, x, nodes):
    """In-plane stress (ne, nip, 3) xx, yy, xy turned from each element's side 1-2 to the x axis."""
    side = x[nodes[:, 1]] - x[nodes[:, 0]]
    c, s = (side / np.linalg.norm(side, axis=1)[:, None]).T[:2, :, None]
    xx, yy, xy = np.moveaxis(block.stress[..., :3], -1, 0)
    return np.stack(
        [c * c * xx + s * s * yy - 2 * c * s * xy, s * s * xx + c * c * yy + 2 * c * s * xy,
         c * s * (xx - yy) + (c * c - s * s) * xy], axis=-1
    )  # fmt: skip


@pytest.mark.parametrize("ihq", [2, 4])
def test_membrane_patch(bench, ihq):
    """u = 1e-3 (x + y/2), v = 1e-3 (y + x/2): stresses 1333.33, 1333.33, 400, and no force inside."""
    block = bench.shells(X, PATCH, THICKNESS, e=1e6, nu=0.25, hourglass=Hourglass(ihq=ihq))
    s = bench.state(X)
    small = 1e-12  # of that field, so that the response is linear
    s.v[:, 0] = small * 1e-3 * (X[:, 0] + X[:, 1] / 2)
    s.v[:, 1] = small * 1e-3 * (X[:, 1] + X[:, 0] / 2)
    f, moment = bench.internal_forces(block, s)
    stress = global_stress(block, X, PATCH) / small
    assert stress == pytest.approx(np.broadcast_to([4000 / 3, 4000 / 3, 400], stress.shape), rel=1e-12)
    assert np.abs(block.stress[..., 3:]).max() == 0
    assert np.abs(f[INNER]).max() < 1e-13 * np.abs(f).max()
    assert np.abs(moment).max() < 1e-13 * np.abs(f).max() * THICKNESS
    assert np.abs(block.hourglass).max() < 1e-13 * np.abs(f).max()


def bend(s, kxx, kyy, kxy):
    """w = -(kxx x^2 + kyy y^2 + kxy x y) / 2 with normals that stay normal: omega_x = w,y, omega_y = -w,x."""
    x, y = s.x[:, 0], s.x[:, 1]
    s.v[:, 2] = -(kxx * x**2 + kyy * y**2 + kxy * x * y) / 2
    s.omega[:, 0] = -(kyy * y + kxy * x / 2)
    s.omega[:, 1] = kxx * x + kxy * y / 2


@pytest.mark.parametrize("nip", [2, 3, 5, 10])
def test_cylindrical_bending_of_rectangles(bench, nip):
    """M_xx = E t^3 / (12 (1 - nu^2)) kappa, M_yy = nu M_xx, no shear, no force inside; on the edge M_xx b."""
    t, kappa, width = 0.02, 1e-15, 0.5
    x, nodes = bench.rectangles(4, 3, 1.0, width)
    block, s = bench.shells(x, nodes, t, nip=nip, hourglass=Hourglass(ihq=4)), bench.state(x)
    bend(s, kappa, 0.0, 0.0)
    f, moment = bench.internal_forces(block, s)
    M = bench.E * t**3 / (12 * (1 - bench.NU**2)) * kappa
    z, weight = (t / 2 * a for a in np.polynomial.legendre.leggauss(nip))
    resultants = np.einsum("p,epc->ec", z * weight, block.stress)
    assert resultants == pytest.approx(np.tile([M, bench.NU * M, 0, 0, 0], (12, 1)), rel=1e-9, abs=1e-9 * M)
    assert moment[x[:, 0] == 1.0, 1].sum() == pytest.approx(M * width, rel=1e-9)
    inside = (x[:, 0] > 0) & (x[:, 0] < 1)
    assert np.abs(moment[inside, 1]).max() < 1e-9 * M * width
    assert np.abs(f).max() < 1e-9 * M  # quadratic in kappa: the membrane strain of the slope


def test_one_point_does_not_bend(bench):
    x, nodes = bench.rectangles(2, 2, 1.0, 1.0)
    block, s = bench.shells(x, nodes, 0.02, nip=1, hourglass=Hourglass(qb=0.0, qw=0.0)), bench.state(x)
    bend(s, 1e-9, 0.0, 0.0)
    _, moment = bench.internal_forces(block, s)
    assert np.abs(moment).max() < 1e-16 * bench.E * 0.02**3


def test_twist_of_rectangles(bench):
    """M_xy = G t^3 / 12 kappa. The warping control feels w = xy: it adds the share QW/2 of the energy."""
    t, kappa, qw = 0.02, 1e-9, 0.1
    x, nodes = bench.rectangles(3, 3, 0.6, 0.6)
    block, s = bench.shells(x, nodes, t, hourglass=Hourglass(ihq=4, qw=qw)), bench.state(x)
    bend(s, 0.0, 0.0, kappa)
    bench.internal_forces(block, s)
    M = bench.E / (2 * (1 + bench.NU)) * t**3 / 12 * kappa
    z, weight = (t / 2 * a for a in np.polynomial.legendre.leggauss(2))
    assert np.einsum("p,epc->ec", z * weight, block.stress)[:, 2] == pytest.approx(M, rel=1e-9)
    assert block.energy["internal"][0] == pytest.approx(M * kappa / 2 * 0.36, rel=1e-9)
    assert block.energy["hourglass"][0] == pytest.approx(qw / 2 * block.energy["internal"][0], rel=1e-9)


def test_bending_patch_fails_on_skewed_elements(bench):
    """Known: the quadratic w of constant curvature leaves shear in a quadrilateral that is no parallelogram."""
    block, s = bench.shells(X, PATCH, THICKNESS, e=1e6, nu=0.25), bench.state(X)
    bend(s, 1e-9, 1e-9, 0.0)
    bench.internal_forces(block, s)
    assert np.abs(block.stress[..., 3:]).max() > 1e-3 * np.abs(block.stress[..., :3]).max()
