"""The law of a planar wall by itself: the common velocity, and the face."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vmharness.explicit.walls.face import covers, face_of
from vmharness.explicit.walls.impulse import common_velocity

speeds = st.floats(-100.0, 100.0)
masses = st.floats(1e-3, 1e3)


@given(st.lists(st.tuples(speeds, masses), min_size=1, max_size=8), speeds, masses)
def test_the_common_velocity_balances_momentum(nodes, w, mass):
    trial, m = map(np.array, zip(*nodes, strict=True))
    root = common_velocity(w, 1.0 / mass, trial, m, np.arange(m.size))
    gained = m @ np.maximum(0.0, root - trial)
    assert root <= w
    assert mass * (w - root) == pytest.approx(gained, rel=1e-9, abs=1e-9 * (mass + m.sum()))


@given(st.lists(st.tuples(speeds, masses), min_size=1, max_size=8), speeds)
def test_a_wall_that_stands_does_not_yield(nodes, w):
    trial, m = map(np.array, zip(*nodes, strict=True))
    assert common_velocity(w, 0.0, trial, m, np.arange(m.size)) == w


def test_a_face_is_orthonormal_and_its_edges_belong_to_it():
    face = face_of(
        np.array([1.0, 2.0, 3.0]), np.array([1.0, 2.0, 5.0]), np.array([4.0, 2.0, 9.0]), (2.0, 1.0)
    )
    np.testing.assert_allclose(face[1:4], [[0, 0, 1], [1, 0, 0], [0, 1, 0]])
    inside = [(1.0, 2.0, 8.0), (3.0, 3.0, 0.0), (2.0, 2.5, 3.0)]
    outside = [(0.99, 2.5, 3.0), (3.01, 2.5, 3.0), (2.0, 1.99, 3.0), (2.0, 3.01, 3.0)]
    assert [covers(face, p) for p in inside + outside] == [True] * 3 + [False] * 4


def test_a_face_without_end_covers_all():
    face = face_of(np.zeros(3), np.array([1.0, 1.0, 1.0]))
    np.testing.assert_allclose(face[1:4] @ face[1:4].T, np.eye(3), atol=1e-15)
    assert covers(face, (1e9, -1e9, 5.0))


def test_directions_that_vanish_are_refused():
    with pytest.raises(ValueError, match="one point"):
        face_of(np.ones(3), np.ones(3))
    with pytest.raises(ValueError, match="no direction across the normal"):
        face_of(np.zeros(3), np.array([0.0, 0.0, 1.0]), np.array([0.0, 0.0, 4.0]), (1.0, 1.0))
