"""Closest points on quadrilaterals and triangles."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from vmharness.explicit.contact.geometry import beyond, interpolate, normal, shape, tangents
from vmharness.explicit.contact.projection import border, closest, project

WARPED = ((0.0, 0.0, 0.1), (2.0, 0.1, -0.1), (2.2, 1.8, 0.15), (-0.1, 2.0, -0.2))
TRIANGLE = ((0.0, 0.0, 0.1), (2.0, 0.1, -0.1), (0.3, 1.8, 0.15), (0.3, 1.8, 0.15))
SQUARE = ((-1.0, -1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, 0.0), (-1.0, 1.0, 0.0))
inside = st.floats(-1.0, 1.0)
fraction = st.floats(0.0, 0.5)


def at(triangle, corners, xi, eta, height=0.0):
    r = np.array(interpolate(corners, shape(triangle, xi, eta)))
    return tuple((r + height * np.array(normal(triangle, corners, xi, eta))).tolist())


@given(inside, inside)
def test_shape_functions_are_a_partition_of_unity_and_nodal(xi, eta):
    for triangle in (False, True):
        assert sum(shape(triangle, xi, eta)) == pytest.approx(1.0, abs=1e-15)
    corners = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
    assert [list(shape(False, *corner)) for corner in corners] == np.eye(4).tolist()
    assert [list(shape(True, *corner)) for corner in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))] == np.eye(4)[
        :3
    ].tolist()


@given(inside, inside, st.floats(-0.3, 0.3))
@settings(max_examples=200)
def test_a_point_over_a_warped_segment_projects_back_to_where_it_came_from(xi, eta, height):
    p = at(False, WARPED, xi, eta, height)
    np.testing.assert_allclose(project(False, WARPED, p, 0.0, 0.0), (xi, eta), atol=1e-9)


@given(fraction, fraction, st.floats(-3.0, 3.0))
def test_a_point_over_a_triangle_projects_back_to_where_it_came_from(xi, eta, height):
    p = at(True, TRIANGLE, xi, eta, height)
    np.testing.assert_allclose(project(True, TRIANGLE, p, 0.3, 0.3), (xi, eta), atol=1e-9)


@given(st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3))
@settings(max_examples=200)
def test_distance_outside_is_to_the_edge_of_a_flat_square(p):
    xi, eta, out = closest(False, SQUARE, tuple(p), 0.0, 0.0)
    distance = np.linalg.norm(np.array(p) - at(False, SQUARE, xi, eta))
    nearest = np.array([*np.clip(p[:2], -1.0, 1.0), 0.0])
    assert distance == pytest.approx(np.linalg.norm(np.array(p) - nearest), abs=1e-12)
    assert out == pytest.approx(max(abs(p[0]), abs(p[1])) - 1.0, abs=1e-12)


@given(st.lists(st.floats(-3.0, 3.0), min_size=3, max_size=3), st.booleans())
@settings(max_examples=100)
def test_the_border_point_is_the_closest_of_the_border(p, triangle):
    corners = TRIANGLE if triangle else WARPED
    xi, eta = border(triangle, corners, tuple(p))
    found = np.linalg.norm(np.array(p) - at(triangle, corners, xi, eta))
    ring = np.array(corners[:3] if triangle else corners)
    along = np.linspace(0.0, 1.0, 401)[:, None, None]
    points = (1.0 - along) * ring + along * np.roll(ring, -1, axis=0)
    sampled = np.linalg.norm(points - np.array(p), axis=-1).min()
    assert sampled - 0.01 <= found <= sampled + 1e-12


def test_how_far_beyond_a_border():
    assert beyond(False, 1.025, 0.0) == pytest.approx(0.025)
    assert beyond(False, 0.2, -0.5) == pytest.approx(-0.5)
    assert beyond(True, -0.0125, 0.5) == pytest.approx(0.025)
    assert beyond(True, 0.5, 0.6) == pytest.approx(0.2)
    assert beyond(True, 1 / 3, 1 / 3) == pytest.approx(-2 / 3)


@pytest.mark.parametrize(("triangle", "corners"), [(False, WARPED), (True, TRIANGLE)])
def test_normal_is_along_the_right_hand_rule_and_across_the_tangents(triangle, corners):
    tangent = np.array(tangents(triangle, corners, 0.3, 0.4))
    n = np.array(normal(triangle, corners, 0.3, 0.4))
    assert n[2] > 0.9
    np.testing.assert_allclose(tangent @ n, 0.0, atol=1e-15)
    assert np.linalg.norm(n) == pytest.approx(1.0)
