"""The neighbour of a segment that is nearer to a node."""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.geometry import at, corners, interpolate, shape
from vmharness.explicit.contact.projection import first_guess, place
from vmharness.explicit.contact.records import Record, Records
from vmharness.explicit.contact.search import joins
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, dot, inlined, subtract
from vmharness.explicit.model.state import Array

Index = NDArray[np.intp]

SMOOTH = 0.5  # cosine between normals of segments that are one surface, and between these and the way to a common edge
SAME = 1e-9  # of a distance: the point on a common border is equally near from both sides


@uncounted
def nearer(
    x: Array, node: Record, touches: Records, s: int, side: float, out: float, away: Vector, n: Vector,
    segments: Records, first: Index, beside: Index,
) -> tuple[int, float, bool]:  # fmt: skip
    """The neighbour of s that is nearest, or -1 where s is; what it makes of the side; whether both share the point.

    Of those that share the point, that is taken which the node is most squarely behind.
    """
    p, best, best_turn, shared, least = at(x, node["row"]), -1, 1.0, False, dot(away, away)
    height = side * dot(away, n)
    squarest = own = -height / max(least, 1e-300) ** 0.5
    for e in range(first[s], first[s + 1]):
        q = beside[e]
        if joins(segments[q], node["row"]) or touched(touches, q, node["count"]):
            continue
        xi, eta = first_guess(segments[q]["triangle"])
        _, _, _, other, m = place(x, segments[q], p, xi, eta)
        turn = joined(x, segments[s], segments[q], side, height, out, n, m, other)
        if turn == 0.0:
            continue
        square = dot(other, other)
        behind = -side * turn * dot(other, m) / max(square, 1e-300) ** 0.5
        common = square <= (1.0 + SAME) * dot(away, away)
        between = (own + behind) / max(
            2.0 + 2.0 * turn * dot(n, m), 1e-300
        ) ** 0.5  # along the mean of the normals
        shared = shared or (common and max(behind, own, between) >= SMOOTH)
        if square < (1.0 - SAME) * least or (square <= (1.0 + SAME) * least and behind > squarest + SAME):
            best, best_turn, least, squarest = q, turn, square, behind
    return best, best_turn, shared


@inlined
def joined(
    x: Array, segment: Record, other: Record, side: float, height: float, out: float, n: Vector, m: Vector, away: Vector
) -> float:  # fmt: skip
    """Whether a node that touches one segment can move on to the other: 1, -1 where sides are exchanged, 0 if not."""
    cosine, two_sided = dot(n, m), other["two_sided"]
    if height >= 0.0 and out > 0.0:  # round the edge
        above = 1.0 if dot(away, m) >= 0.0 else -1.0
        return above * side if two_sided else max(above, 0.0)
    if abs(cosine) >= SMOOTH and (two_sided or cosine > 0.0):
        return 1.0 if cosine > 0.0 else -1.0
    if height < 0.0:  # from wall to wall of a valley, which see each other's front
        between = subtract(middle(x, other), middle(x, segment))
        turn = -side if dot(between, m) > 0.0 else side
        return turn if side * dot(between, n) > 0.0 and (two_sided or turn > 0.0) else 0.0
    return 0.0


@inlined
def middle(x: Array, segment: Record) -> Vector:
    """The middle of a segment."""
    xi, eta = first_guess(segment["triangle"])
    return interpolate(corners(x, segment["nodes"]), shape(segment["triangle"], xi, eta))


@inlined
def touched(touches: Records, s: int, count: int) -> bool:
    """Whether the node touches segment s."""
    found = False
    for k in range(count):
        found = found or touches[k]["segment"] == s
    return found
