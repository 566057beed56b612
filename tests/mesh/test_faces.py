"""Faces of solids: outward, and only those on the outside."""

import numpy as np
import pytest

from vmharness.explicit.contact.surface.choice import lies_behind, reverse
from vmharness.mesh.faces import area_vectors, faces_of_solids, outside

CUBE = np.array(
    [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float
)
WEDGE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0, 1], [0.5, 1, 1]], float)


def block(n):
    """Corners (x, nodes) of n^3 unit cubes."""
    k, j, i = np.meshgrid(*3 * [np.arange(n + 1)], indexing="ij")
    x = np.column_stack([i.ravel(), j.ravel(), k.ravel()]).astype(float)
    number = np.arange((n + 1) ** 3).reshape(3 * [n + 1])
    low = [number[:-1, :-1, :-1], number[:-1, :-1, 1:], number[:-1, 1:, 1:], number[:-1, 1:, :-1]]
    high = [number[1:, :-1, :-1], number[1:, :-1, 1:], number[1:, 1:, 1:], number[1:, 1:, :-1]]
    return x, np.column_stack([corner.ravel() for corner in (*low, *high)])


@pytest.mark.parametrize(
    ("x", "nodes", "volume", "count"),
    [(CUBE, np.arange(8), 1.0, 6), (WEDGE, np.array([0, 1, 2, 3, 4, 4, 5, 5]), 0.5, 5)],
)
def test_faces_close_the_solid_and_point_outward(x, nodes, volume, count):
    faces, solid = faces_of_solids(nodes[None])
    areas = area_vectors(x[faces])
    assert faces.shape == (count, 4)
    assert not solid.any()
    np.testing.assert_allclose(areas.sum(axis=0), 0.0, atol=1e-15)
    centre = np.array([x[np.unique(face)].mean(axis=0) for face in faces])
    # The divergence theorem for x / 3, exact on flat faces, with any point of each face.
    assert (centre * areas).sum() / 3.0 == pytest.approx(volume)
    assert ((centre - x.mean(axis=0)) * areas).sum(axis=1).min() > 0.0


def test_outside_of_a_block_is_its_skin():
    x, nodes = block(3)
    faces, solid = faces_of_solids(nodes)
    skin = outside(faces)
    assert skin.sum() == 6 * 9
    assert set(solid[skin]) == set(range(27)) - {13}  # but the cube in the middle
    assert set(np.unique(faces[skin])) == set(np.flatnonzero(((x == 0) | (x == 3)).any(axis=1)))


def test_triangles_that_two_wedges_share_are_inside_whichever_corner_comes_twice():
    nodes = np.array([[0, 1, 2, 3, 4, 4, 5, 5], [3, 2, 6, 7, 5, 5, 8, 8]])  # end to end
    faces, _ = faces_of_solids(nodes)
    assert outside(faces).sum() == 8
    rolled = np.concatenate([faces, [[5, 5, 2, 3]]])
    assert outside(rolled).sum() == 8


def test_segments_face_away_from_nodes_behind_them():
    x = np.vstack([CUBE, [[0.5, 0.5, 2.0]]])
    top, behind, before = np.array([[4, 5, 6, 7], [4, 5, 6, 6]]), np.array([0]), np.array([8])
    assert lies_behind(top, x, behind)
    assert not lies_behind(top, x, before)
    tilted = (
        x
        @ np.array([[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
        @ np.array([[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]])
    )
    for segments in (top, reverse(top)):  # a node that lies in the surface, but for round-off
        assert not lies_behind(segments, np.vstack([tilted, tilted[top[0]].mean(axis=0)]), np.array([9]))
    np.testing.assert_allclose(area_vectors(x[reverse(top)]), -area_vectors(x[top]))
    assert reverse(top)[1].tolist() == [5, 4, 6, 6]
