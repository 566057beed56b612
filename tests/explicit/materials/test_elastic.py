"""Plane stress of Hooke's law."""

import numpy as np
import pytest

from vmharness.explicit.materials.elastic import constants, plane_stress

E, NU = 210.0, 0.3


def stress(strain, before=(0.0, 0.0, 0.0, 0.0, 0.0)):
    return plane_stress(constants(E, NU), 1.0, *strain, *before, np.zeros(0), 0, 1)


def test_solid_with_no_normal_stress():
    """s = lambda tr(e) I + 2 G e with the thickness strain that is returned: s_zz = 0 and the same in the plane."""
    exx, eyy, exy, eyz, ezx = 1e-3, -4e-4, 7e-4, 2e-4, -3e-4
    *sigma, ezz = stress((exx, eyy, exy, eyz, ezx))
    G, lam = E / (2 * (1 + NU)), E * NU / ((1 + NU) * (1 - 2 * NU))
    trace = exx + eyy + ezz
    assert lam * trace + 2 * G * ezz == pytest.approx(0, abs=1e-16)
    solid = [lam * trace + 2 * G * exx, lam * trace + 2 * G * eyy, G * exy, G * eyz, G * ezx]
    assert sigma == pytest.approx(solid, rel=1e-13)


def test_uniaxial_tension():
    *sigma, ezz = stress((1e-3, -NU * 1e-3, 0.0, 0.0, 0.0))
    assert sigma == pytest.approx([E * 1e-3, 0, 0, 0, 0], abs=1e-16)
    assert ezz == pytest.approx(-NU * 1e-3)


def test_increments_add_up():
    one, two = np.random.default_rng(1).normal(size=(2, 5))
    after = stress(two, stress(one)[:5])
    assert after[:5] == pytest.approx(stress(one + two)[:5], rel=1e-12)


@pytest.mark.parametrize(
    ("e", "nu", "message"),
    [
        (0.0, 0.3, "E = 0.0: .*positive"),
        (-1.0, 0.3, "positive"),
        (float("nan"), 0.3, "positive"),
        (1.0, 0.5, "PR = 0.5: .*between -1 and 0.5"),
        (1.0, -1.0, "between"),
        (1.0, float("nan"), "between"),
    ],
)
def test_impossible_constants(e, nu, message):
    with pytest.raises(ValueError, match=message):
        constants(e, nu)
