"""Ridges: where a node behind a surface belongs to the other side of a sharp edge.

A face that moves along a surface sweeps over its nodes: they lie in the penetration of the two bodies, just within the
sharp edge that leads. Such a node has passed through the leading face, but the face that slides over it is far nearer,
and opposes the node's own surface; that face takes the node over. The contact force stays the gradient of k g^2/2 with
g the least of the depths, and does no work on a closed path.

The condition on the node's own surface keeps a node in place that rests at the edge of a body, such as a corner of one
of two blocks that are stacked flush: its surface does not oppose the side of the block below. A node without a surface
of its own, such as a mass or the end of a beam, moves over the ridge where it is deeper than the segment extends beyond
its border (MAXPAR).

A node that has come through the leading face within the last step moves to the other side at once, if it has come as
deep as that is far: the leading face would otherwise stop it with its damper, at the speed of sliding. While a node is
still in front of the other side, it is outside the body, and has no contact with the leading face.
"""

from vmharness.explicit.contact.geometry import at, centre, corners, size
from vmharness.explicit.contact.projection import midpoint, project_node
from vmharness.explicit.contact.records import Record, Records
from vmharness.explicit.contact.search import has_corner
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, cross, dot, subtract, unit
from vmharness.explicit.state import Array, Index

OPPOSED = -0.5  # cosine between the normals of surfaces that face each other, at most
SHARP = 0.5  # cosine between the normals of segments at a ridge, at most
NONE, OUTSIDE = -1, -2  # no segment takes the node over; it is in front of the one that would


@uncounted
def over_ridge(
    # model
    segments: Records, first: Index, neighbours: Index, own: Index, maxpar: float,
    # node, and its contact with segment s, in which the node has come `reach` deep in this step
    x: Array, node: Record, s: int, height: float, n: Vector, reach: float,
) -> int:  # fmt: skip
    """Find the nearest segment that takes a node over from segment s across a ridge, or NONE, or OUTSIDE."""
    segment, best = segments[s], NONE
    if height >= 0.0 or segment["two_sided"]:
        return best
    p, least = at(x, node["row"]), max(height * height, reach * reach)
    for e in range(first[s], first[s + 1]):
        q = neighbours[e]
        other = segments[q]
        towards = subtract(midpoint(x, other), midpoint(x, segment))
        if other["two_sided"] or dot(towards, n) >= 0.0 or has_corner(other, node["row"]):
            continue
        xi, eta = centre(other["triangle"])
        _, _, _, away, m = project_node(x, other, p, xi, eta)
        if dot(n, m) >= SHARP:
            continue
        if dot(away, m) >= 0.0:
            if opposes(own, x, node, m):
                return OUTSIDE
        elif dot(away, away) < least and belongs(own, maxpar, x, node, segment, height, m, dot(away, away)):
            best, least = q, dot(away, away)
    return best


@uncounted
def belongs(
    # model
    own: Index, maxpar: float, x: Array,
    # node, its contact with `segment`, and another segment: normal, distance squared
    node: Record, segment: Record, height: float, m: Vector, square: float,
) -> bool:  # fmt: skip
    """Whether a node that is behind both belongs to the other segment rather than to `segment`."""
    if node["own_from"] == node["own_to"]:
        deep = -height > 0.5 * (maxpar - 1.0) * size(corners(x, segment["nodes"]))
        return deep and square < height * height
    return bool(opposes(own, x, node, m))


@uncounted
def opposes(own: Index, x: Array, node: Record, m: Vector) -> bool:
    """Whether a face of the node's own surface is opposed to a segment with the normal m."""
    for i in range(node["own_from"], node["own_to"]):
        c = corners(x, own[i])
        across = unit(cross(subtract(c[2], c[0]), subtract(c[3], c[1])))
        if dot(across, m) <= OPPOSED:
            return True
    return False
