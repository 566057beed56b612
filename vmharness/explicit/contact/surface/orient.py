"""Orientation of segments that act from one side (ORIEN)."""

import numpy as np

from vmharness.explicit.state import Array, Index
from vmharness.mesh.faces import area_vectors

ROUND_OFF = 1e-9  # of the segments' size: nodes that lie in the surface are not behind it


def faces_away(segments: Index, x: Array, tracked: Index) -> bool:
    """Whether the tracked nodes (nt,) lie, on the whole, behind the segments (ns, 4).

    The sign of sum A n . (mean of the tracked nodes - centre of the segment).
    """
    centre, areas = x[segments].mean(axis=1), area_vectors(x[segments])
    side = np.einsum("ij,ij->", x[tracked].mean(axis=0) - centre, areas)
    return bool(side < -ROUND_OFF * (np.linalg.norm(areas, axis=1) ** 1.5).sum())


def turned(segments: Index) -> Index:
    """The segments (ns, 4) with their normals reversed; a triangle's third corner stays the one that comes twice.

    >>> turned(np.array([[1, 2, 3, 4], [1, 2, 3, 3]])).tolist()
    [[4, 3, 2, 1], [2, 1, 3, 3]]
    """
    triangle = segments[:, 2] == segments[:, 3]
    return np.where(triangle[:, None], segments[:, [1, 0, 2, 3]], segments[:, ::-1])
