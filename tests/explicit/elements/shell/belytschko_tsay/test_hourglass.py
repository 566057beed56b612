"""Each hourglass pattern of a square is resisted by just the force that its formula gives."""

import numpy as np
import pytest

from vmharness.explicit.elements.shell.belytschko_tsay import Hourglass

A, T, DT = 0.2, 0.01, 0.5
H = np.array([1.0, -1.0, 1.0, -1.0])
NODES = np.array([[0, 2, 3, 1]])
NU, KAPPA, E, RHO = 0.3, 5 / 6, 2.1e11, 7850.0
G, C0 = E / (2 * (1 + NU)), np.sqrt(E / RHO)
# B.B = 2 / a^2 on a square
STIFF = {
    "membrane": E * T / 4,
    "warping": KAPPA * G * T**3 / (6 * A**2),
    "bending": E * T**3 / 96,
}
VISCOUS = {
    "membrane": RHO * C0 * T * A / 4,
    "warping": RHO * C0 * T**2 * np.sqrt(KAPPA / (3 * (1 + NU))) / 4,
    "bending": RHO * C0 * T**2 * A**2 / (32 * np.sqrt(3)),
}
PATTERNS = [(0, "membrane"), (1, "membrane"), (2, "warping"), (3, "bending"), (4, "bending")]


def nodal(bench, control, k, rate):
    """Internal forces and moments (4, 6) by corner after a step in pattern k at a rate, and the block."""
    x, _ = bench.rectangles(1, 1, A, A)
    block, s = bench.shells(x, NODES, T, E, NU, RHO, shrf=KAPPA, hourglass=control), bench.state(x)
    s.dt = DT
    field = np.zeros((4, 6))
    field[NODES[0], k] = rate * H
    s.v[:], s.omega[:] = field[:, :3], field[:, 3:]
    return np.hstack(bench.internal_forces(block, s))[NODES[0]], block


@pytest.mark.parametrize(("k", "mode"), PATTERNS)
@pytest.mark.parametrize("ihq", [1, 2, 3, 4, 5, 6])
def test_force_of_each_pattern(bench, ihq, k, mode):
    coefficient = {"membrane": 0.05, "warping": 0.02, "bending": 0.08}
    control = Hourglass(ihq=ihq, qm=0.05, qw=0.02, qb=0.08)
    rate = 1e-12  # so small that the geometry stays
    forces, block = nodal(bench, control, k, rate)
    expected = np.zeros((4, 6))
    if ihq <= 3:
        expected[:, k] = H * coefficient[mode] * VISCOUS[mode] * 4 * rate
    else:
        expected[:, k] = H * coefficient[mode] * STIFF[mode] * 4 * rate * DT
    assert forces == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(expected).max())
    assert block.energy["internal"][0] == pytest.approx(0, abs=1e-12 * np.abs(expected).max() * rate)
    work = 0.5 * np.sum(expected[:, k] * H * rate * DT)
    assert block.energy["hourglass"][0] == pytest.approx(work, rel=1e-9)


@pytest.mark.parametrize("k", range(5))
def test_without_control_the_patterns_are_free(bench, k):
    forces, _ = nodal(bench, Hourglass(ihq=4, qm=0, qb=0, qw=0), k, 1e-9)
    assert np.abs(forces).max() < 1e-9 * 1e-9 * E * T


def test_stiffness_form_remembers_and_viscous_does_not(bench):
    for ihq, remembers in ((4, True), (2, False)):
        _, block = nodal(bench, Hourglass(ihq=ihq), 0, 1e-9)
        x, _ = bench.rectangles(1, 1, A, A)
        f, _ = bench.internal_forces(block, bench.state(x))
        assert bool(np.abs(f).max() > 0) is remembers


@pytest.mark.parametrize("ihq", [0, 7, 8])
def test_other_types_are_refused(ihq):
    with pytest.raises(ValueError, match=rf"IHQ = {ihq}.*1, 2, 3 .viscous. and 4, 5, 6 .stiffness."):
        Hourglass(ihq=ihq)
