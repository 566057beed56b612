"""Plane stress of Hooke's law."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.materials.elastic import Elastic, plane_stress

E, NU = 210.0, 0.3


def stress(strain, before=(0.0, 0.0, 0.0, 0.0, 0.0)):
    return plane_stress(Elastic(E, NU), 1.0, *strain, *before, np.zeros(0), 0, 1)


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


@pytest.mark.parametrize("pr", [0.5, 0.7, -1.0])
def test_impossible_ratio_names_card_and_field(wall_and, pr):
    with pytest.raises(DeckError, match=rf"\*MAT_ELASTIC: PR = {pr}: must lie between -1 and 0.5"):
        wall_and(f"*MAT_ELASTIC\n2,1.0,1.0,{pr}\n*PART\np\n2,1,2\n*ELEMENT_SHELL\n2,2,1,2,3,4\n")
