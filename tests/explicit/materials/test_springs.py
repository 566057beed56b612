"""Laws of springs and dampers, one element, against what they say in words."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.deck import DeckError
from vmharness.explicit.build import build
from vmharness.explicit.materials import spring_elastoplastic
from vmharness.explicit.materials._characteristic import ordinate
from vmharness.explicit.materials.spring_elastoplastic import ElastoplasticSpring

K, KT, FY = 100.0, 20.0, 5.0
HARDENING = K * KT / (K - KT)


SPRING = ElastoplasticSpring(K, FY, HARDENING)


def follow(path, constants=SPRING):
    """Forces along a path of elongations, and the history at its end."""
    history = np.zeros(2)
    return [spring_elastoplastic.spring(constants, 1.0, d, 0.0, history, 0, 1) for d in path], history


def test_monotonic_is_bilinear():
    d = np.array([0.01, 0.05, 0.06, 0.1, 0.2])
    force, _ = follow(d)
    np.testing.assert_allclose(force, np.where(d < 0.05, K * d, FY + KT * (d - 0.05)), rtol=1e-13)
    np.testing.assert_allclose(follow(-d)[0], -np.array(force), rtol=1e-13)


def test_unloading_is_elastic_and_reverse_yield_is_isotropic():
    """From f = 8 at d = 0.2: back with K, yield again at -8, the same magnitude as reached before, then with KT."""
    force, history = follow([0.2, 0.19, 0.04, 0.0])
    np.testing.assert_allclose(force, [8.0, 7.0, -8.0, -8.0 - 0.04 * KT], rtol=1e-13)
    assert history[0] == pytest.approx(8.8 / K)  # at d = 0 the force is -8.8 = -K d_p
    assert history[1] == pytest.approx((8.8 - FY) / HARDENING)  # and |f| = FY + H p


def test_perfect_plasticity_keeps_the_yield_force():
    force, history = follow([0.2, 0.1, 0.3], ElastoplasticSpring(K, FY, 0.0))
    np.testing.assert_allclose(force, [FY, -FY, FY], rtol=1e-13)
    assert history[0] == pytest.approx(0.3 - FY / K, rel=1e-12)
    assert history[1] == pytest.approx(
        0.15 + 0.0 + 0.1, rel=1e-12
    )  # back to -FY just as far as elastic reaches


@given(st.lists(st.floats(-1.0, 1.0), min_size=1, max_size=8), st.integers(2, 7))
def test_steps_of_any_size_give_the_same(turns, pieces):
    """A path cut into pieces ends where the path in one go between its turning points ends."""
    fine = np.concatenate(
        [np.linspace(a, b, pieces + 1)[1:] for a, b in zip([0.0, *turns], turns, strict=False)]
    )
    coarse_force, coarse = follow(turns)
    fine_force, history = follow(fine)
    assert fine_force[-1] == pytest.approx(coarse_force[-1], abs=1e-9)
    np.testing.assert_allclose(history, coarse, atol=1e-11)


def test_characteristic_interpolates_and_goes_on_with_its_last_slope():
    curve = (np.array([-1.0, 0.0, 0.5, 2.0]), np.array([-3.0, 0.0, 2.0, 2.6]))
    x = np.linspace(-1.0, 2.0, 61)
    np.testing.assert_allclose([ordinate(curve, one) for one in x], np.interp(x, *curve), atol=1e-14)
    assert ordinate(curve, -2.0) == pytest.approx(-6.0)
    assert ordinate(curve, 4.5) == pytest.approx(2.6 + 0.4 * 2.5)


DECK = """*KEYWORD
*CONTROL_TERMINATION
1.0
*SECTION_DISCRETE
1

*PART
p
1,1,1
*NODE
1,0,0,0,7,7
2,1.0,0,0
*ELEMENT_MASS
1,2,2.0
*INITIAL_VELOCITY_NODE
2,{v}
*DEFINE_CURVE
3
{first}
0.0,{middle}
1.0,4.0
2.0,10.0
*{material}
*ELEMENT_DISCRETE
1,1,1,2,0,1.0,0,{offset}
"""


def at_start(deck, material, v=0.0, offset=0.0, first="-1.0,-2.0", middle=0.0):
    """The element of one part at t = 0, after its first forces."""
    text = DECK.format(material=material, v=v, offset=offset, first=first, middle=middle)
    model = build(deck(text))
    model.forces[0].add(model.state)
    return model.forces[0]


def test_spring_by_curve_stores_the_area_under_it(deck):
    element = at_start(deck, "MAT_SPRING_NONLINEAR_ELASTIC\n1,3", offset=1.5)
    assert element.force[0] == pytest.approx(7.0, rel=1e-13)
    assert element.energy["spring and damper"][0] == pytest.approx(
        0.5 * 4.0 + 0.5 * (4.0 + 7.0) * 0.5, rel=1e-6
    )
    assert element.stable_step() == pytest.approx(2.0 * (2.0 / 6.0) ** 0.5)  # the steepest slope is 6


def test_damper_by_curve_reads_the_rate(deck):
    for v, force in ((0.5, 2.0), (1.5, 7.0), (-0.5, -1.0), (-3.0, -6.0)):
        element = at_start(deck, "MAT_DAMPER_NONLINEAR_VISCOUS\n1,3", v=v, offset=0.4)
        assert element.force[0] == pytest.approx(force, rel=1e-13)
    assert element.energy["spring and damper"][0] == 0.0  # a damper stores nothing of its offset
    assert element.stable_step() == pytest.approx(2.0 * 2.0 / 6.0)


def test_names_of_manual_and_number_are_the_same(deck):
    for name, card in {
        "MAT_S01": "1,5.0", "MAT_S02": "1,5.0", "MAT_S03": "1,5.0,1.0,2.0", "MAT_S04": "1,3", "MAT_S05": "1,3"
    }.items():  # fmt: skip
        at_start(deck, f"{name}\n{card}")


@pytest.mark.parametrize(
    ("material", "extra", "message"),
    [
        ("MAT_SPRING_ELASTOPLASTIC\n1,5.0,5.0,1.0", {}, r"\*MAT_SPRING_ELASTOPLASTIC: KT = 5.0: must be less than K = 5"),
        ("MAT_SPRING_ELASTOPLASTIC\n1,5.0,1.0,0.0", {}, r"FY = 0.0: must be greater than 0"),
        ("MAT_SPRING_ELASTIC\n1", {}, r"\*MAT_SPRING_ELASTIC: K = \(blank\): a value is required"),
        ("MAT_SPRING_NONLINEAR_ELASTIC\n1,3,4", {}, r"LCR = 4: only 0 is supported"),
        ("MAT_SPRING_NONLINEAR_ELASTIC\n1,8", {}, r"LCD = 8: no \*DEFINE_CURVE with LCID = 8; defined: 3"),
        ("MAT_SPRING_NONLINEAR_ELASTIC\n1,3", {"middle": 0.5}, r"LCD = 3: the curve must pass through \(0, 0\)"),
        ("MAT_DAMPER_NONLINEAR_VISCOUS\n1,3", {"first": "-1.0,-2.0\n-0.5,1.0", "middle": 0.5}, r"LCDR = 3: the curve must pass"),
    ],
)  # fmt: skip
def test_wrong_cards_are_told(deck, material, extra, message):
    with pytest.raises(DeckError, match=message):
        at_start(deck, material, **extra)
