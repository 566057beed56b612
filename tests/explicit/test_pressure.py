"""*LOAD_SEGMENT and *LOAD_SEGMENT_SET against what a pressure does to a body."""

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.loop import steps

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]  # nodes 11 to 18
FACES = [
    (11, 13, 14, 12),
    (15, 16, 18, 17),
    (11, 12, 16, 15),
    (13, 17, 18, 14),
    (11, 15, 17, 13),
    (12, 14, 18, 16),
]


def box(skew=0.0):
    """Eight free masses at the corners of a cube, displaced at random, and its faces with normals outward."""
    x = np.array(CORNERS, float) + skew * np.random.default_rng(7).uniform(-1, 1, (8, 3)) + [5.0, 0.0, 0.0]
    nodes = "".join(f"{11 + i},{p[0]},{p[1]},{p[2]}\n" for i, p in enumerate(x))
    masses = "".join(f"{111 + i},{11 + i},1.0\n" for i in range(8))
    faces = "".join(",".join(map(str, face)) + "\n" for face in FACES)
    return f"*NODE\n{nodes}*ELEMENT_MASS\n{masses}*SET_SEGMENT\n4\n{faces}"


def test_a_closed_box_feels_no_net_force_or_moment_however_skew(wall_and):
    model = wall_and(box(skew=0.3) + "*LOAD_SEGMENT_SET\n4,1,2.0\n")
    next(steps(model))
    s = model.state
    assert np.abs(s.f).max() > 0.1
    np.testing.assert_allclose(s.f.sum(axis=0), 0.0, atol=1e-14)
    np.testing.assert_allclose(np.cross(s.x, s.f).sum(axis=0), 0.0, atol=1e-14)


def test_pressure_pushes_into_the_face_by_quarters(wall_and):
    model = wall_and(box() + "*LOAD_SEGMENT\n1,2.0,0.0,15,16,18,17\n")
    next(steps(model))
    assert model.state.f[8:, 2].tolist() == [-0.5] * 4  # the upper face, of area 1
    assert not model.state.f[:8].any()


def test_a_triangle_gives_a_third_to_each_node(wall_and):
    model = wall_and(box() + "*LOAD_SEGMENT\n1,6.0,0.0,15,16,18,18\n")
    next(steps(model))
    np.testing.assert_allclose(model.state.f[[8, 9, 11], 2], -1.0, rtol=1e-15)
    np.testing.assert_allclose(model.state.f.sum(axis=0), [0.0, 0.0, -3.0], atol=1e-15)


def test_forces_follow_the_face_as_it_moves_and_work_is_p_dv(wall_and):
    # The upper face rises at speed 1 and its half x > 5.5 moves outward at 1: its area is 1 + t.
    up = "*SET_NODE_LIST\n5\n15,16,17,18\n*SET_NODE_LIST\n6\n16,18\n"
    motion = "*BOUNDARY_PRESCRIBED_MOTION_SET\n5,3,0,1\n6,1,0,1\n"
    model = wall_and(
        box()
        + up
        + motion
        + "*LOAD_SEGMENT_SET\n4,1,2.0\n".replace("4,1", "7,1")
        + "*SET_SEGMENT\n7\n15,16,18,17\n"
    )
    pressure = model.forces[-1]
    for s in steps(model):
        np.testing.assert_allclose(pressure.forces.sum(axis=(0, 1)), [0, 0, -2.0 * (1 + s.t)], atol=1e-12)
        work = -2.0 * (s.t + s.t**2 / 2)  # -p int A dz
        assert pressure.energy["external work"][0] == pytest.approx(work, rel=1e-12)


def test_arrival_time_shifts_the_curve(wall_and):
    ramp = "*DEFINE_CURVE\n2\n0.0,1.0\n2.0,5.0\n"
    model = wall_and(box() + ramp + "*LOAD_SEGMENT_SET\n4,2,1.0,0.4\n")
    for s in steps(model):
        p = 1.0 + 2.0 * (s.t - 0.4) if s.t >= 0.4 else 0.0
        upper = model.forces[-1].forces[1].sum(axis=0)[2]
        side = np.ptp(s.x[8:12, 0])  # the box is compressed as it goes
        assert upper == pytest.approx(-p * side**2, rel=1e-9)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ("*LOAD_SEGMENT\n-2,1.0,0.0,15,16,18,17\n", r"\*LOAD_SEGMENT: LCID = -2: must be greater than 0"),
        ("*LOAD_SEGMENT\n1,1.0,0.0,15,16,18,99\n", r"\*LOAD_SEGMENT: N4 = 99: no \*NODE 99"),
        ("*LOAD_SEGMENT_SET\n5,1\n", r"SSID = 5: no \*SET_SEGMENT with SID = 5; defined: 4"),
    ],
)
def test_what_is_refused(wall_and, keywords, message):
    with pytest.raises(DeckError, match=message):
        wall_and(box() + keywords)
