"""*MAT_PIECEWISE_LINEAR_PLASTICITY from its card."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.materials import piecewise_linear_plasticity
from vmharness.explicit.materials._plasticity.piecewise_linear import value_and_slope

CARD = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-6,210.0,0.3,{sigy}\n{second}\n{eps}\n{es}\n"
CURVE = "*DEFINE_CURVE\n{lcid}\n{points}\n"


@pytest.fixture
def constants(deck):
    """What the law gets of a card and curves."""

    def from_card(sigy="", second="", eps="", es="", **curves):
        blocks = [CURVE.format(lcid=name[1:], points="\n".join(points)) for name, points in curves.items()]
        text = "*KEYWORD\n" + CARD.format(sigy=sigy, second=second, eps=eps, es=es) + "".join(blocks)
        read = deck(text)
        return piecewise_linear_plasticity.constants(read, read.one(piecewise_linear_plasticity.KEYWORD))

    return from_card


def values(Y, p):
    return [value_and_slope(Y, x)[0] for x in p]


def test_bilinear(constants):
    E, nu, C, Y, rate = constants(sigy="0.4,2.0")
    assert (E, nu, C, rate) == (210.0, 0.3, None, None)
    assert values(Y, [0.0, 0.1]) == pytest.approx([0.4, 0.4 + 0.1 * 2.0 * 210 / 208])


@pytest.mark.parametrize(
    "given",
    [
        dict(eps="0.0,0.1,0.3", es="0.3,0.4,0.5"),
        dict(second=",,7", _7=["0.0,0.3", "0.1,0.4", "0.3,0.5"]),
        dict(
            sigy="99.0,9.0", second=",,7", eps="0.0,1.0", es="5.0,6.0", _7=["0.0,0.3", "0.1,0.4", "0.3,0.5"]
        ),
    ],
)
def test_curve(constants, given):
    """Linear between points, the last slope beyond them; LCSS before EPS and ES before SIGY."""
    Y = constants(**given).Y
    assert values(Y, [0.0, 0.05, 0.1, 0.2, 0.3, 0.7]) == pytest.approx([0.3, 0.35, 0.4, 0.45, 0.5, 0.7])


def test_eight_points(constants):
    p = np.linspace(0, 1, 8)
    eps, es = (",".join(map(repr, a.tolist())) for a in (p, 1 + np.sqrt(p)))
    Y = constants(eps=eps, es=es).Y
    assert values(Y, p) == pytest.approx(1 + np.sqrt(p))


def test_rate_by_curve_goes_before_cowper_symonds(constants):
    assert constants(sigy="0.4", second="40.0,5.0").rate == (None, 1 / 40, 1 / 5, None)
    assert constants(sigy="0.4", second="40.0,5.0,0,0,1.0").rate[3] == (40.0, 5.0, 0.4, 0.0)  # SIGY z
    points = dict(eps="0.0,0.1,0.3", es="0.3,0.4,0.5")
    assert constants(second="40.0,5.0,0,0,1.0", **points).rate[3] == (40.0, 5.0, 0.0, 1.0)  # Y z
    table, *_ = constants(sigy="0.4", second="40.0,5.0,0,8", _8=["0.0,1.0", "10.0,1.5"]).rate
    assert values(table, [0.0, 4.0, 20.0]) == pytest.approx([1.0, 1.2, 2.0])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (dict(), "SIGY = 0.0: a yield stress is required where there is neither LCSS nor EPS and ES"),
        (dict(sigy="0.4,210.0"), "ETAN = 210.0: must be less than E = 210"),
        (dict(sigy="0.4,0.0,0.5"), "FAIL = 0.5: only 0.0, 1e[+]20 and 1e[+]21 are supported"),
        (dict(sigy="0.4,0.0,,1.0"), "TDEL = 1.0: only 0.0 is supported"),
        (dict(sigy="0.4", second="0.0,0.0,0,0,3.0"), "VP = 3.0: only 0.0 and 1.0 are supported"),
        (dict(sigy="0.4", second="40.0,0.5,0,0,1.0"), "P = 0.5: must be at least 1 with VP = 1"),
        (dict(sigy="0.4", second="40.0"), "P = 0.0: must be greater than 0, since C is given"),
        (dict(eps="0.01,0.1", es="0.3,0.4"), "EPS1 = 0.01: the first plastic strain must be 0"),
        (dict(eps="0.0", es="0.3"), "EPS2 = 0.0: at least two points are needed"),
        (dict(eps="0.0,0.2,0.1", es="0.3,0.4,0.5"), "EPS3 = 0.1: must be greater than EPS2"),
        (dict(eps="0.0,0.1,0.2", es="0.3,0.4,0.35"), "ES3 = 0.35: must not be less than ES2"),
        (dict(eps="0.0,0.1", es="0.0,0.4"), "ES1 = 0.0: must be greater than 0"),
        (dict(second=",,9"), "LCSS = 9: no [*]DEFINE_CURVE with LCID = 9; defined: none"),
        (dict(second=",,7", _7=["0.0,0.3"]), "LCSS = 7: the curve needs at least two points"),
    ],
)
def test_what_it_refuses(constants, given, message):
    with pytest.raises(DeckError, match=rf"deck.k:\d+: \*MAT_PIECEWISE_LINEAR_PLASTICITY: {message}"):
        constants(**given)


@pytest.mark.parametrize(
    ("points", "message"),
    [
        (["0.1,0.3", "0.2,0.4"], "A1 = 0.1: the first plastic strain of a yield curve must be 0"),
        (["0.0,0.0", "0.2,0.4"], "O1 = 0.0: a yield stress must be greater than 0"),
        (["0.0,0.3", "0.2,0.4", "0.3,0.39"], "O1 = 0.39: a yield stress must not fall"),
    ],
)
def test_wrong_curve_is_named_where_it_lies(constants, points, message):
    with pytest.raises(DeckError, match=rf"deck.k:\d+: \*DEFINE_CURVE: {message}"):
        constants(second=",,7", _7=points)
