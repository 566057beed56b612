"""SHRF is bounded: the rotary inertia that keeps shear slower than the membrane has a pole there."""

import pytest

from vmharness.deck import DeckError
from vmharness.explicit.build import build

TEXT = """*KEYWORD
*CONTROL_TERMINATION
1.0
*PART
plate
1,1,1
*SECTION_SHELL
1,2,{shrf},2
0.1
*MAT_ELASTIC
1,1.0,3.0,{nu}
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0
*ELEMENT_SHELL
1,1,{corners}
*END
"""


@pytest.mark.parametrize("corners", ["1,2,3,4", "1,2,3,3"])
@pytest.mark.parametrize(("nu", "pole"), [(0.0, 2.0), (0.25, 10 / 3), (-0.5, 2.0)])
def test_a_factor_at_the_pole_or_beyond_is_refused(deck, corners, nu, pole):
    for shrf in (pole, 1.1 * pole, 1e300):
        with pytest.raises(
            DeckError, match=rf"deck.k:8: .*SHRF = .*less than 2 .* = {pole:.6g}; 5/6 is usual"
        ):
            build(deck(TEXT.format(corners=corners, nu=nu, shrf=shrf)))
    model = build(deck(TEXT.format(corners=corners, nu=nu, shrf=0.99 * pole)))
    assert (model.state.inertia[:3] > 0.0).all()


@pytest.mark.parametrize("nu", [-1.0, 0.5])
def test_a_ratio_of_poisson_at_which_moduli_are_infinite_is_refused(deck, nu):
    with pytest.raises(DeckError, match=r"PR = .* must lie between -1 and 0.5"):
        build(deck(TEXT.format(corners="1,2,3,4", nu=nu, shrf=1.0)))
