"""Closest points on bilinear segments."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from vmharness.explicit.segment import closest_point, normal, offset, shape, tangents

CORNERS = np.arange(4)
WARPED = np.array([[0.0, 0.0, 0.1], [2.0, 0.1, -0.1], [2.2, 1.8, 0.15], [-0.1, 2.0, -0.2]])
inside = st.floats(-1.0, 1.0)


@given(inside, inside)
def test_shape_functions_are_a_partition_of_unity_and_nodal(xi, eta):
    assert sum(shape(i, xi, eta) for i in range(4)) == pytest.approx(1.0, abs=1e-15)
    corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    assert [[shape(i, *corner) for corner in corners] for i in range(4)] == np.eye(4).tolist()


@given(inside, inside, st.floats(-0.3, 0.3))
@settings(max_examples=200)
def test_a_point_over_a_warped_segment_projects_back_to_where_it_came_from(xi, eta, height):
    # p = r(xi, eta) + height n has its closest point at (xi, eta).
    n = np.array(normal(WARPED, CORNERS, xi, eta))
    p = -np.array(offset(WARPED, CORNERS, np.zeros(3), xi, eta)) + height * n
    found = closest_point(WARPED, CORNERS, p)
    np.testing.assert_allclose(found, (xi, eta, abs(height)), atol=1e-9)


@given(st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3))
@settings(max_examples=200)
def test_distance_outside_is_to_the_edge_of_a_flat_square(p):
    square = np.array([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]])
    *_, distance = closest_point(square, CORNERS, np.array(p))
    nearest = np.array([*np.clip(p[:2], -1.0, 1.0), 0.0])
    assert distance == pytest.approx(np.linalg.norm(p - nearest), abs=1e-12)


def test_normal_is_along_the_right_hand_rule_and_across_the_tangents():
    tangent = np.array(tangents(WARPED, CORNERS, 0.3, -0.4)).reshape(2, 3)
    n = np.array(normal(WARPED, CORNERS, 0.3, -0.4))
    assert n[2] > 0.9
    np.testing.assert_allclose(tangent @ n, 0.0, atol=1e-15)
    assert np.linalg.norm(n) == pytest.approx(1.0)
