"""Inertia that the deck gives: what no body has is refused, and the borders are plates, rods and points."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.loop import steps

NODAL = """*SET_NODE_LIST
30
11
*CONSTRAINED_NODAL_RIGID_BODY_INERTIA
30,0,30
0.0,0.0,0.0,2.0
{ixx},{ixy},0.0,{iyy},0.0,{izz}

*NODE
11,0.0,0.0,0.0
"""


@pytest.mark.parametrize(
    ("given", "moments"),
    [
        (dict(ixx=1.0, iyy=2.0, izz=3.001), "1, 2, 3.001: the last exceeds the sum of the others"),
        (dict(ixx=9.0, iyy=2.0, izz=3.0), "2, 3, 9: the last exceeds the sum of the others"),
        (dict(ixx=0.0, iyy=1.0, izz=2.0), "0, 1, 2: the last exceeds the sum of the others"),
        (dict(ixx=0.0, iyy=0.0, izz=1.0), "0, 0, 1: the last exceeds the sum of the others"),
    ],
)
def test_a_moment_beyond_the_sum_of_the_others_is_no_body(space, free, given, moments):
    for text in (free(**given), NODAL.format(ixy=0.0, **given)):
        with pytest.raises(
            DeckError, match=rf"INERTIA: IXX = {given['ixx']}: no body has principal moments {moments}"
        ):
            space(text)


def test_a_tensor_that_is_not_positive_is_no_body(space):
    with pytest.raises(
        DeckError, match=r"no body has principal moments -0\.5, 2\.5, 2\.5: the first is negative"
    ):
        space(NODAL.format(ixx=1.0, ixy=1.5, iyy=1.0, izz=2.5))


@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e12])
def test_a_flat_plate_and_the_digits_of_a_card_are_allowed(space, bodies, free, unit):
    model = space(free(ixx=1.2345 * unit, iyy=2.3456 * unit, izz=3.5802 * unit))  # the sum is 3.5801
    np.testing.assert_allclose(np.sort(bodies(model).principal[0]), np.array([1.2345, 2.3456, 3.5802]) * unit)


@pytest.mark.parametrize("tilt", [0.0, 0.3])
def test_a_rod_turns_about_the_axes_that_it_has_inertia_about(space, bodies, tilt):
    # Along (cos, sin, 0), in five digits; about z it keeps its spin, and nothing pulls it round its own axis.
    c, s = np.cos(tilt), np.sin(tilt)
    given = {
        name: f"{value:.4g}"
        for name, value in (("ixx", s * s), ("ixy", -s * c), ("iyy", c * c), ("izz", 1.0))
    }
    text = NODAL.format(**given).replace("11,0.0,0.0,0.0", f"11,{2 * c},{2 * s},0.0")
    model = space(text + "*INITIAL_VELOCITY_RIGID_BODY\n30,0.0,0.0,0.0,0.0,0.0,1.0\n", end=2.0 * np.pi)
    assert bodies(model).principal[0].min() < 1e-4
    for state in steps(model):
        place = [2.0 * np.cos(tilt + state.t), 2.0 * np.sin(tilt + state.t), 0.0]
        np.testing.assert_allclose(state.x[0], place, atol=2e-4)
        assert model.kinetic() == pytest.approx(0.5, rel=1e-9)


@pytest.mark.parametrize(("moment", "place"), [(1.0, (1.0, 0.1, 0.0)), (0.0, (0.1, 0.0, 0.0))])
def test_no_node_may_turn_a_rod_about_its_axis_or_a_point_at_all(space, free, moment, place):
    given = dict(ixx=0.0, iyy=moment, izz=moment)
    space(free(**given, **dict(zip("xyz", (place[0] * moment, 0.0, 0.0), strict=True))))
    with pytest.raises(
        DeckError, match=r"IXX = 0.0: a principal moment is zero, but node 11 is off that axis"
    ):
        space(free(**given, **dict(zip("xyz", place, strict=True))))
