"""Visible faces of solids: those of one solid only, sorted from far to near."""

import numpy as np
from numpy.typing import NDArray

from vmharness.round_off import ROUND_OFF, ordered

Index = NDArray[np.intp]

FACES = (
    (0, 1, 2, 3),
    (4, 5, 6, 7),
    (0, 1, 5, 4),
    (1, 2, 6, 5),
    (2, 3, 7, 6),
    (3, 0, 4, 7),
)  # of a hexahedron


def outer(solids: Index) -> Index:
    """Nodes (nf, 4) of the faces that belong to one of the hexahedra (ne, 8) only.

    >>> two = np.array([[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]])
    >>> len(outer(two))
    10
    """
    faces = solids[:, FACES].reshape(-1, 4)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[np.sort(first[count == 1])]


def far_first(faces: Index, x: NDArray[np.float64], viewer: NDArray[np.float64]) -> Index:
    """The faces in the order of painting: their middles by the direction `viewer` (3,) toward the eye.

    Those as far as each other keep their order.
    """
    depth = (x[faces].mean(axis=1) @ viewer).tolist()
    least = ROUND_OFF * float(np.abs(x).max(initial=0.0))
    return faces[ordered(range(len(faces)), depth.__getitem__, least)]
