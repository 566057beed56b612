"""*LOAD_NODE_POINT and *LOAD_NODE_SET: what a force does to a free mass."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit import energy
from vmharness.explicit.loop import steps

BALLS = "*NODE\n5,0,0,1\n6,1,0,1\n*ELEMENT_MASS\n105,5,2.0\n106,6,4.0\n*SET_NODE_LIST\n3\n5,6\n"
RAMP = "*DEFINE_CURVE\n2\n0.0,0.0\n2.0,4.0\n"


def test_momentum_is_the_impulse_and_work_the_kinetic_energy(wall_and):
    loads = "*LOAD_NODE_POINT\n5,1,1,3.0\n5,3,1,-1.0\n6,2,2,0.5\n*LOAD_NODE_SET\n3,3,1,2.0\n"
    model = wall_and(BALLS + RAMP + loads)
    works = energy.accounts(model.forces, "external work")
    for s in steps(model):
        v = s.v + 0.5 * s.dt * s.a
        # Trapezoid of forces over the steps: exact for both curves.
        np.testing.assert_allclose(2.0 * v[4], [3.0 * s.t, 0.0, 1.0 * s.t], atol=1e-12)
        np.testing.assert_allclose(4.0 * v[5], [0.0, 0.5 * s.t**2, 2.0 * s.t], atol=1e-12)
        # Leapfrog: work + m dt^2/8 (a_n^2 - a_0^2) is what the kinetic energy gains.
        known = 4.0 * s.dt**2 / 8.0 * s.a[5, 1] ** 2
        assert energy.kinetic(s) == pytest.approx(sum(work[0] for work in works) + known, rel=1e-11)
    assert len(works) == 2  # one force a curve


def test_moment_turns_a_node_with_inertia(wall_and):
    # A shell's nodes have rotary inertia; 5 to 8 are free.
    plate = "*NODE\n5,5,5,0\n6,6,5,0\n7,6,6,0\n8,5,6,0\n*ELEMENT_SHELL\n2,1,5,6,7,8\n"
    model = wall_and(plate + "*LOAD_NODE_POINT\n6,6,1,1e-9\n")
    next(steps(model))
    s = model.state
    np.testing.assert_allclose(s.alpha[5], [0.0, 1e-9 / s.inertia[5], 0.0])
    assert np.count_nonzero(s.alpha) == 1
    assert not s.a.any()


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ("*LOAD_NODE_POINT\n5,4,1\n", r"\*LOAD_NODE_POINT: DOF = 4: only 1, 2, 3, 5, 6 and 7 are supported"),
        ("*LOAD_NODE_POINT\n5,1,1,1.0,3\n", r"\*LOAD_NODE_POINT: CID = 3: only 0 is supported"),
        ("*LOAD_NODE_POINT\n55,1,1\n", r"\*LOAD_NODE_POINT: NID = 55: no \*NODE 55"),
        ("*LOAD_NODE_SET\n4,1,1\n", r"\*LOAD_NODE_SET: NSID = 4: no .* with SID = 4; defined: 3"),
        ("*LOAD_NODE_SET\n3,1,7\n", r"\*LOAD_NODE_SET: LCID = 7: no \*DEFINE_CURVE with LCID = 7"),
    ],
)
def test_what_is_refused(wall_and, keywords, message):
    with pytest.raises(DeckError, match=message):
        wall_and(BALLS + keywords)
