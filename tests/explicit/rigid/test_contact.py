"""A rigid plate that falls on the wall of the shared fixtures: it bounces, and turns if it falls aslant."""

import numpy as np
import pytest

from vmharness.explicit import energy, probe
from vmharness.explicit.loop import steps

PLATE = """*PART
plate
5,5,5
*SECTION_SHELL
5,2
0.1
*MAT_RIGID
5,1.0,300.0,0.0


*ELEMENT_SHELL
5,5,15,16,17,18
*NODE
15,-0.5,-0.5,{low}
16,0.5,-0.5,{high}
17,0.5,0.5,{high}
18,-0.5,0.5,{low}
*SET_NODE_LIST
2
15,16,17,18
*CONTROL_CONTACT
1.0

*CONTACT_NODES_TO_SURFACE
2,1,4,3


*INITIAL_VELOCITY_RIGID_BODY
5,0.0,0.0,-0.1
"""


@pytest.mark.parametrize(("low", "high"), [(0.01, 0.01), (0.01, 0.11)])
def test_a_plate_bounces_with_the_energy_that_it_had(wall_and, low, high):
    model = wall_and(PLATE.format(low=low, high=high), end=4.0, density=1e-6)
    (stored,) = energy.accounts(model.forces, "contact")
    v, spin = (probe.rigid(model, 5, what) for what in ("z-velocity", "y-angular-velocity"))
    mass = 0.1 * np.hypot(1.0, high - low)
    force, impulse, before, fastest = probe.contact(model, 1, "z-force"), 0.0, 0.0, 0.0
    for s in steps(model):
        assert model.kinetic() + stored[0] == pytest.approx(0.5 * mass * 0.1**2, rel=1e-4)
        impulse += 0.5 * (before + force()) * s.dt
        before, fastest = force(), max(fastest, abs(spin()))
    assert force() == 0.0
    assert impulse == pytest.approx(mass * (v() + 0.1), rel=1e-4)
    # With all mass in the corners, the edges bounce each by itself: in between, one goes up and one down.
    assert v() == pytest.approx(0.1, rel=1e-3)
    assert fastest == pytest.approx(0.0 if low == high else 0.2, rel=0.02, abs=1e-9)
    assert np.ptp(model.state.lumped[4:8]) == pytest.approx(0.0, abs=1e-15)
