"""Each hourglass pattern of a cube is resisted by just the force that its formula gives."""

import numpy as np
import pytest

from vmharness.explicit.elements.solid import measures
from vmharness.explicit.elements.solid.one_point import Hourglass, moduli

A, DT, RATE = 0.2, 0.5, 1e-12  # so slow that the geometry stays
CUBE = np.array(
    [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1.0]]
)
X, Y, Z = CUBE.T
PATTERNS = [Y * Z, Z * X, X * Y, X * Y * Z]
NODES = np.arange(8)[None]


def nodal(bench, control, h, axis, x=None):
    x = A / 2 * CUBE if x is None else x
    block, s = bench.solids(x, NODES, 1, control), bench.state(x, DT)
    s.v[:, axis] = RATE * h
    return bench.internal_forces(block, s), block


@pytest.mark.parametrize("h", PATTERNS)
@pytest.mark.parametrize("axis", range(3))
@pytest.mark.parametrize("ihq", [1, 2, 3, 4, 5])
def test_force_of_each_pattern(bench, ihq, axis, h):
    """Viscous: QM rho V^(2/3) c / 4 h (h . v). Stiffness: omega = sqrt(6 QM) c/L with the mass of the cube."""
    M = bench.E * (1 - bench.NU) / ((1 + bench.NU) * (1 - 2 * bench.NU))
    c, qm = np.sqrt(M / bench.RHO), 0.07
    f, block = nodal(bench, Hourglass(ihq, qm), h, axis)
    expected = np.zeros((8, 3))
    if ihq <= 3:
        expected[:, axis] = qm * bench.RHO * A**2 * c / 4 * h * (8 * RATE)
    else:
        expected[:, axis] = 6 * qm * (c / A) ** 2 * bench.RHO * A**3 / 8 * h * RATE * DT
    assert f == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(expected).max())
    work = 0.5 * np.sum(expected[:, axis] * h * RATE * DT)
    assert block.energy["hourglass"][0] == pytest.approx(work, rel=1e-9)
    assert abs(block.energy["internal"][0]) < 1e-9 * work


@pytest.mark.parametrize("h", PATTERNS)
def test_without_control_the_patterns_are_free(bench, h):
    f, _ = nodal(bench, Hourglass(4, 0.0), h, 0)
    assert np.abs(f).max() < 1e-12 * RATE * bench.E


def test_stiffness_form_remembers_and_viscous_does_not(bench):
    for ihq, remembers in ((4, True), (2, False)):
        _, block = nodal(bench, Hourglass(ihq), PATTERNS[0], 0)
        assert bool(np.abs(bench.internal_forces(block, bench.state(A / 2 * CUBE))).max() > 0) is remembers


def test_type_1_resists_a_linear_field_in_a_distorted_element_and_others_do_not(bench):
    x = A / 2 * (CUBE + 0.3 * np.random.default_rng(1).uniform(-1, 1, (8, 3)))
    spin = x @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 0.0]]).T
    for ihq, free in ((1, False), (2, True), (4, True)):
        block, s = bench.solids(x, NODES, 1, Hourglass(ihq)), bench.state(x, DT)
        s.v[:] = 1e-9 * spin
        bench.internal_forces(block, s)
        assert bool(block.energy["hourglass"][0] < 1e-30) is free


def test_viscous_control_limits_the_step_where_it_is_strong(bench):
    """2 m q / Q = V^(1/3) / (8 QM c): at QM = 0.15 it rules a cube, at 0.1 it does not."""
    M = bench.E * (1 - bench.NU) / ((1 + bench.NU) * (1 - 2 * bench.NU))
    c = np.sqrt(M / bench.RHO)
    for qm, fraction in ((0.1, 1.0), (0.15, 1 / 1.2)):
        block = bench.solids(A / 2 * CUBE, NODES, 1, Hourglass(2, qm))
        block.add(bench.state(A / 2 * CUBE))
        assert block.stable_step() == pytest.approx(fraction * A / c)


@pytest.mark.parametrize("seed", range(3))
def test_stiffness_of_a_distorted_element(bench, seed):
    """QM rho c^2 / 2V sum over patterns of |dV/dx_k|^2: 4 QM rho c^2 V sum B_iI B_iI with B = dV/dx / V."""
    x = CUBE + 0.3 * np.random.default_rng(seed).uniform(-1, 1, (8, 3))
    V, slope = measures(x[None])[0][0], np.zeros((8, 3))
    for place in np.ndindex(8, 3):
        d = np.zeros((8, 3))
        d[place] = 1e-5
        slope[place] = (measures((x + d)[None])[0][0] - measures((x - d)[None])[0][0]) / 2e-5
    expected = 4 * 0.1 * 5.0 / V * np.sum(slope**2)
    assert moduli(x[None], 1.0, 5.0, Hourglass(4)) == pytest.approx([expected], rel=1e-8)


@pytest.mark.parametrize("ihq", [0, 6, 7])
def test_other_types_are_refused(ihq):
    with pytest.raises(ValueError, match=rf"IHQ = {ihq}.*1, 2, 3 .viscous. and 4, 5 .stiffness."):
        Hourglass(ihq)
