"""*MAT_PLASTIC_KINEMATIC from its card."""

import pytest

from vmharness.deck import DeckError
from vmharness.explicit.materials import plastic_kinematic

CARD = "*MAT_PLASTIC_KINEMATIC\n{first}\n{second}\n"


@pytest.fixture
def constants(deck):
    """What the law gets of a card."""

    def from_card(first, second=""):
        read = deck("*KEYWORD\n" + CARD.format(first=first, second=second))
        return plastic_kinematic.constants(read, read.one(plastic_kinematic.KEYWORD))

    return from_card


@pytest.mark.parametrize(
    ("beta", "C", "slope"),
    [(0.0, 2.0 * 210 / 208, 0.0), (1.0, 0.0, 2.0 * 210 / 208), (0.5, 210 / 208, 210 / 208)],
)
def test_plastic_modulus_is_shared_by_beta(constants, beta, C, slope):
    """E_p = E Et / (E - Et)."""
    got = constants(f"1,7.8e-6,210.0,0.3,0.4,2.0,{beta}")
    assert got == (210.0, 0.3, pytest.approx(C), ((0.4, pytest.approx(slope)), None, None), None)


def test_rate(constants):
    assert constants("1,1.0,210.0,0.3,0.4", "40.0,5.0").rate == (None, 1 / 40, 1 / 5, None)
    plastic = constants("1,1.0,210.0,0.3,0.4", "40.0,5.0,0.0,1.0").rate
    assert plastic == (None, 1 / 40, 1 / 5, (40.0, 5.0, 0.0, 1.0))  # of Y


@pytest.mark.parametrize(
    ("first", "second", "message"),
    [
        ("1,1.0,210.0,0.3,0.4,210.0", "", "ETAN = 210.0: must be less than E = 210"),
        ("1,1.0,210.0,0.3,0.4,-1.0", "", "ETAN = -1.0: must be at least 0"),
        ("1,1.0,210.0,0.3,0.0", "", "SIGY = 0.0: must be greater than 0"),
        ("1,1.0,210.0,0.5,0.4", "", "PR = 0.5: must lie between -1 and 0.5"),
        ("1,1.0,210.0,0.3,0.4,0.0,1.5", "", "BETA = 1.5: must lie between 0 .kinematic. and 1 .isotropic."),
        ("1,1.0,210.0,0.3,0.4", "40.0", "SRP = 0.0: must be greater than 0, since SRC is given"),
        ("1,1.0,210.0,0.3,0.4", "0.0,5.0", "SRC = 0.0: must be greater than 0, since SRP is given"),
        ("1,1.0,210.0,0.3,0.4", "0.0,0.0,0.1", "FS = 0.1: only 0.0 is supported"),
        ("1,1.0,210.0,0.3,0.4", "0.0,0.0,0.0,2.0", "VP = 2.0: only 0.0 and 1.0 are supported"),
    ],
)
def test_what_it_refuses(constants, first, second, message):
    with pytest.raises(DeckError, match=rf"deck.k:\d+: \*MAT_PLASTIC_KINEMATIC: {message}"):
        constants(first, second)
