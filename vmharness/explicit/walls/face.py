"""The face of a wall: corner T, normal n, edges l and m = n x l, and the lengths of both, as rows of one array (5, 3).

The lengths are infinite for an infinite wall.
"""

import numpy as np

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import Vector
from vmharness.explicit.state import Array

NORMAL, EDGE_L, EDGE_M, LENGTHS = 1, 2, 3, 4


def face_of(
    tail: Array, head: Array, edge: Array | None = None, lengths: tuple[float, float] = (np.inf, np.inf)
) -> Array:
    """The face (5, 3) with normal from `tail` to `head`, and edge l from `tail` toward `edge`.

    Only the component of the edge across the normal counts. Raises ValueError where a direction vanishes.
    """
    normal = _unit(head - tail, "the tail and the head of the normal are one point")
    toward = edge - tail if edge is not None else np.eye(3)[np.argmin(np.abs(normal))]
    first = _unit(toward - (toward @ normal) * normal, "the edge has no direction across the normal")
    return np.array([tail, normal, first, np.cross(normal, first), [*lengths, 0.0]])


def _unit(vector: Array, what: str) -> Array:
    length = float(np.linalg.norm(vector))
    if length == 0.0:
        raise ValueError(what)
    return vector / length


@kernel
def coordinate(face: Array, k: int, p: Vector) -> float:
    """(p - T) . e_k, with e_k in row k of the face."""
    corner, e = face[0], face[k]
    return (p[0] - corner[0]) * e[0] + (p[1] - corner[1]) * e[1] + (p[2] - corner[2]) * e[2]


@kernel
def covers(face: Array, p: Vector) -> bool:
    """True if the projection of p lies on the face or on its edges."""
    lengths = face[LENGTHS]
    if lengths[0] == np.inf:
        return True
    return (
        0.0 <= coordinate(face, EDGE_L, p) <= lengths[0] and 0.0 <= coordinate(face, EDGE_M, p) <= lengths[1]
    )
