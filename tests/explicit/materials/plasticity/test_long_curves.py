"""Long yield curves seen row by row: on the curve after each step, however many points it passes."""

import numpy as np
import pytest

from vmharness.explicit.elements.beam import truss
from vmharness.explicit.elements.shell import _point as shell_point
from vmharness.explicit.elements.shell import _rows as shell_rows
from vmharness.explicit.elements.solid import _rows as solid_rows
from vmharness.explicit.elements.solid import _stress as solid_point
from vmharness.explicit.kernels.simd import LANES
from vmharness.explicit.materials._plasticity.constants import Plastic
from vmharness.explicit.materials._plasticity.long_curves import has_long_curve, with_law
from vmharness.explicit.materials._plasticity.piecewise_linear import curve, line, value_and_slope
from vmharness.explicit.materials._plasticity.plane_stress import plane_stress
from vmharness.explicit.materials._plasticity.solid import solid
from vmharness.explicit.materials._plasticity.uniaxial import uniaxial

P = np.concatenate([np.linspace(0, 0.01, 30), np.geomspace(0.011, 0.2, 30)])
CONCAVE = 0.3 + np.sqrt(P)
WAVY = np.cumsum(np.where(np.arange(P.size) % 3, 0.001, 0.02)) + 0.3  # steep after flat
RATES = {"static": None, "by plastic rate": (None, 1 / 40.4, 1 / 5, (40.4, 5.0, 0.3, 0.0))}
DT = 1e-3


def shell(update, constants, rng, size):
    """Buffer, stress and history of shells after a few steps."""
    work, stress, history = np.zeros(shell_rows.ROWS * LANES), np.zeros(5 * LANES), np.zeros(LANES)
    section, strains = np.ones(LANES), slice(shell_rows.MEMBRANE * LANES, shell_rows.N * LANES)
    work[shell_rows.AREA * LANES : shell_rows.WORK * LANES] = 1.0
    for _ in range(6):
        work[strains] = size * rng.normal(size=9 * LANES)
        update(work, DT, section, 0.5, 1.0, 0.8, constants, stress, history)
    return work, stress, history


def hexahedron(update, constants, rng, size):
    """The same of solids."""
    work, stress, history = np.zeros(solid_rows.ROWS * LANES), np.zeros(6 * LANES), np.zeros(LANES)
    work[solid_rows.VOLUME * LANES : (solid_rows.VOLUME + 1) * LANES] = 1.0
    for _ in range(6):
        work[solid_rows.STRAIN * LANES : (solid_rows.STRAIN + 6) * LANES] = size * rng.normal(size=6 * LANES)
        update(work, DT, constants, stress, history)
    return work, stress, history


def bar(update, constants, rng, size):
    """The same of bars."""
    work, stress, history = np.zeros(truss.ROWS * LANES), np.zeros(LANES), np.zeros(LANES)
    work[:LANES] = 1.0
    for _ in range(6):
        work[truss.V * LANES : (truss.V + 1) * LANES] = size / DT * rng.normal(size=LANES)
        update(work, DT, 1.0, np.ones(LANES), constants, stress, history)
    return work, stress, history


POINTS = {
    "shell": (shell, shell_point.stress_at_point, plane_stress),
    "solid": (hexahedron, solid_point.stress_at_point, solid),
    "bar": (bar, truss.stretch, uniaxial),
}


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("kind", POINTS)
def test_close_to_a_search(kind, rate):
    """From steps within a row to steps over many, in stress, history, resultants and work.

    Not to round-off: at many corners a search leaves Newton's rule of the laws further from the root.
    """
    steps, update, law = POINTS[kind]
    by_rows, searching = (with_law(update, law, long_curve) for long_curve in (True, False))
    for stresses in (CONCAVE, WAVY):
        constants = Plastic(210.0, 0.3, None, curve(P, stresses), RATES[rate])
        for size in (2e-3, 0.02):
            one, two = (steps(f, constants, np.random.default_rng(5), size) for f in (by_rows, searching))
            for a, b in zip(one, two, strict=True):
                np.testing.assert_allclose(a, b, rtol=1e-4, atol=1e-7)
            assert one[2].max() > 0.2 * size


def effective(kind, stress):
    """Mises stress of the elements."""
    s = stress.reshape(-1, LANES)
    if kind == "bar":
        return np.abs(s[0])
    xx, yy, zz, *shears = s if kind == "solid" else (s[0], s[1], 0.0 * s[0], *s[2:])
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(0.5 * normal + 3 * sum(shear**2 for shear in shears))


@pytest.mark.parametrize("kind", POINTS)
@pytest.mark.parametrize("size", [2e-3, 0.02])
def test_every_element_is_at_its_own_place_of_the_curve(kind, size):
    """To round-off; the yielding ones at Y(p), the others below."""
    steps, update, law = POINTS[kind]
    for stresses in (CONCAVE, WAVY):
        Y = curve(P, stresses)
        constants = Plastic(210.0, 0.3, None, Y, None)
        _, stress, p = steps(with_law(update, law, True), constants, np.random.default_rng(5), size)
        ratio = effective(kind, stress) / [value_and_slope(Y, x)[0] for x in p]
        assert ratio.max() == pytest.approx(1.0, abs=1e-13)
        assert np.sum(ratio > 1 - 1e-13) >= LANES // 2
        assert p.max() > 3 * size


def test_only_a_yield_curve_of_many_points_is_long():
    assert has_long_curve(Plastic(210.0, 0.3, None, curve(P, CONCAVE), None))
    assert not has_long_curve(Plastic(210.0, 0.3, None, curve(P[:8], CONCAVE[:8]), None))
    assert not has_long_curve(Plastic(210.0, 0.3, None, line(0.3, 1.0), None))
    assert not has_long_curve((210.0, 0.3))
    assert not has_long_curve((210.0, 0.3, 1.0, 2))
