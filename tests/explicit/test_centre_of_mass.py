"""The centre of mass as a channel: of the model and of a part."""

import pytest

from vmharness.explicit.loop import steps
from vmharness.explicit.probes import ProbeError, probe

# Two square shells that share two nodes: parts of masses 2 and 6, and a point mass of 4 at a far corner.
# (The fixed wall of the fixture has 4e-5.)
PLATES = """*PART
light
11,1,2
heavy
12,1,3
*MAT_ELASTIC
2,5.0,1.0
3,15.0,1.0
*ELEMENT_SHELL
11,11,11,12,15,14
12,12,12,13,16,15
*ELEMENT_MASS
13,13,4.0
*NODE
11,0.0,0.0,9.0
12,2.0,0.0,9.0
13,4.0,0.0,9.0
14,0.0,2.0,9.0
15,2.0,2.0,9.0
16,4.0,2.0,9.0
"""
MOVING = "*INITIAL_VELOCITY\n0\n2.0\n"


@pytest.mark.parametrize(("part", "mass"), [(11, 2.0), (12, 6.0), ("all", 12.0)])
def test_a_body_that_moves_as_one(wall_and, part, mass):
    model = wall_and(PLATES + MOVING, end=1.0)
    show = {
        name: probe(model, centre=part, component=f"x-{name}")
        for name in ("displacement", "velocity", "momentum")
    }
    *_, s = steps(model)
    assert show["velocity"]() == pytest.approx(2.0, rel=1e-5)
    assert show["momentum"]() == pytest.approx(2.0 * mass, rel=1e-5)
    assert show["displacement"]() == pytest.approx(2.0 * s.t, rel=1e-5)


def test_a_load_moves_the_centre_however_the_body_deforms(wall_and):
    model = wall_and(PLATES + "*LOAD_NODE_POINT\n11,1,1,0.06\n", end=5.0)
    velocity = probe(model, centre="all", component="x-velocity")
    for s in steps(model):
        assert velocity() == pytest.approx(0.06 * s.t / 12.0, rel=1e-5, abs=1e-15)
    assert s.x[4, 0] - s.x[5, 0] > -1.99  # of the loaded edge, 2 long


def test_what_has_no_mass_is_named(wall_and):
    with pytest.raises(ProbeError, match="no elements with mass in part 5"):
        probe(wall_and(PLATES), centre=5, component="x-velocity")
