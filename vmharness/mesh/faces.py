"""Faces of solids, with outward normals, and the faces of a set of solids that are on its outside.

A face is four corners (n, 4), counter-clockwise as seen from outside; a triangle has its third corner twice.
"""

import numpy as np
from numpy.typing import NDArray

Index = NDArray[np.intp]

# Corners of a hexahedron whose nodes 1 to 4, seen from 5 to 8, turn left.
HEXAHEDRON = np.array(
    [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)], np.intp
)


def faces_of_solids(nodes: Index) -> tuple[Index, Index]:
    """Faces (nf, 4) of solids with `nodes` (ne, 8), and which solid (nf,) each belongs to.

    A wedge n1 n2 n3 n4 n5 n5 n6 n6 has three quadrilaterals and two triangles.

    >>> faces, solid = faces_of_solids(np.array([[0, 1, 2, 3, 4, 4, 5, 5]]))
    >>> faces.tolist(), solid.tolist()
    ([[0, 3, 2, 1], [0, 1, 4, 4], [1, 2, 5, 4], [2, 3, 5, 5], [3, 0, 4, 5]], [0, 0, 0, 0, 0])
    """
    faces = nodes[:, HEXAHEDRON].reshape(-1, 4)
    solid = np.repeat(np.arange(nodes.shape[0]), HEXAHEDRON.shape[0])
    same = faces == np.roll(faces, -1, axis=1)  # as the next corner
    kept = same.sum(axis=1) < 2
    faces, same, solid = faces[kept], same[kept], solid[kept]
    triangle = np.flatnonzero(same.any(axis=1))
    # The pair of equal corners comes last.
    first = (np.argmax(same[triangle], axis=1)[:, None] + np.array([2, 3, 4, 5])) % 4
    faces[triangle] = np.take_along_axis(faces[triangle], first, axis=1)
    return faces, solid


def outside(faces: Index) -> NDArray[np.bool_]:
    """Which of the faces (n, 4) no other has all corners in common with: those that one solid alone has."""
    _, inverse, count = np.unique(corner_sets(faces), axis=0, return_inverse=True, return_counts=True)
    return np.asarray(count[inverse.ravel()] == 1)


def corner_sets(faces: Index) -> Index:
    """The corners (n, 4) of each face in increasing order, whichever way it turns; a triangle's begin with -1.

    >>> corner_sets(np.array([[7, 5, 3, 3], [5, 3, 7, 7], [4, 3, 2, 1]])).tolist()
    [[-1, 3, 5, 7], [-1, 3, 5, 7], [1, 2, 3, 4]]
    """
    ordered = np.sort(faces, axis=1)
    twice = ordered[:, 1:] == ordered[:, :-1]
    ordered[:, 1:][twice] = -1
    return np.sort(ordered, axis=1)


def area_vectors(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """A n (n, 3) of faces with `corners` (n, 4, 3): half the cross product of the diagonals."""
    return np.asarray(0.5 * np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]))
