"""Neighbours of a segment: those that share a node with it, and the one of them that is nearest to a given node."""

import numpy as np

from vmharness.explicit.contact.geometry import at, centre
from vmharness.explicit.contact.projection import midpoint, project_node
from vmharness.explicit.contact.records import Record, Records, is_active
from vmharness.explicit.contact.search import has_corner
from vmharness.explicit.kernels.compiled import kernel, uncounted
from vmharness.explicit.kernels.vector import Vector, dot, inlined, subtract
from vmharness.explicit.state import Array, Index

SMOOTH = 0.5  # cosine between normals of segments that are one surface, and between these and the way to a common edge
SAME = 1e-9  # of a distance: the point on a common border is equally near from both sides


@kernel
def find_neighbours(nodes: Index) -> tuple[Index, Index]:
    """For segments (ns, 4): those that share a node with segment s are found[first[s] : first[s + 1]], in order."""
    segments, rows = nodes.shape[0], 0
    for s in range(segments):
        for i in range(4):
            rows = max(rows, nodes[s, i] + 1)
    start = np.zeros(rows + 1, np.intp)
    for s in range(segments):
        for i in range(4):
            start[nodes[s, i] + 1] += 1
    start = np.cumsum(start)
    around = np.empty(4 * segments, np.intp)  # the segments around node r are around[start[r] : start[r + 1]]
    fill = start.copy()
    for s in range(segments):
        for i in range(4):
            around[fill[nodes[s, i]]] = s
            fill[nodes[s, i]] += 1

    first, found = np.zeros(segments + 1, np.intp), np.empty(0, np.intp)
    last = np.zeros(segments, np.intp)  # what each segment was last found by
    for sweep in range(2):  # count, then fill
        count = 0
        for s in range(segments):
            finder = 2 * s + sweep + 1
            last[s] = finder
            for i in range(4):
                for k in range(start[nodes[s, i]], start[nodes[s, i] + 1]):
                    other = around[k]
                    if last[other] != finder:
                        last[other] = finder
                        if sweep == 1:
                            found[count] = other
                        count += 1
            first[s + 1] = count
        if sweep == 0:
            found = np.empty(count, np.intp)
    return first, found


@uncounted
def nearest_neighbour(
    # model
    segments: Records, first: Index, neighbours: Index,
    # node, and its contact with segment s
    x: Array, node: Record, states: Records, s: int, side: float, out: float, away: Vector, n: Vector,
) -> tuple[int, float, bool]:  # fmt: skip
    """Find the neighbour that is nearer to the node than segment s, or -1 where none is.

    Return it, the factor of the side (-1 where sides are exchanged), and whether s and a neighbour share the closest
    point behind a valley. Of neighbours that share the point, the one is taken whose normal the node is most squarely
    behind.
    """
    p, best, best_turn, shared, least = at(x, node["row"]), -1, 1.0, False, dot(away, away)
    height = side * dot(away, n)
    squarest = own = -height / max(least, 1e-300) ** 0.5
    for e in range(first[s], first[s + 1]):
        q = neighbours[e]
        if has_corner(segments[q], node["row"]) or is_active(states, q, node["count"]):
            continue
        xi, eta = centre(segments[q]["triangle"])
        _, _, _, other, m = project_node(x, segments[q], p, xi, eta)
        turn = connection(x, segments[s], segments[q], side, height, out, n, m, other)
        if turn == 0.0:
            continue
        square = dot(other, other)
        behind = -side * turn * dot(other, m) / max(square, 1e-300) ** 0.5
        common = square <= (1.0 + SAME) * dot(away, away)
        # along the mean of the normals
        between = (own + behind) / max(2.0 + 2.0 * turn * dot(n, m), 1e-300) ** 0.5
        shared = shared or (common and max(behind, own, between) >= SMOOTH)
        if square < (1.0 - SAME) * least or (square <= (1.0 + SAME) * least and behind > squarest + SAME):
            best, best_turn, least, squarest = q, turn, square, behind
    return best, best_turn, shared


@inlined
def connection(
    # model
    x: Array, segment: Record, other: Record,
    # contact with `segment`: side, height, distance beyond it, normal
    side: float, height: float, out: float, n: Vector,
    # projection on `other`: normal, p - r
    m: Vector, away: Vector,
) -> float:  # fmt: skip
    """Whether a contact can move on from a segment to the other: 1, -1 where sides are exchanged, 0 if not."""
    cosine, two_sided = dot(n, m), other["two_sided"]
    if height >= 0.0 and out > 0.0:  # round the edge
        above = 1.0 if dot(away, m) >= 0.0 else -1.0
        return above * side if two_sided else max(above, 0.0)
    if abs(cosine) >= SMOOTH and (two_sided or cosine > 0.0):
        return 1.0 if cosine > 0.0 else -1.0
    if height < 0.0:  # from wall to wall of a valley, which see each other's front
        between = subtract(midpoint(x, other), midpoint(x, segment))
        turn = -side if dot(between, m) > 0.0 else side
        return turn if side * dot(between, n) > 0.0 and (two_sided or turn > 0.0) else 0.0
    return 0.0
