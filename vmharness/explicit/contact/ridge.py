"""Ridges: where a node behind a surface belongs to the other side of a sharp edge.

A face that moves along a surface sweeps over its nodes: they lie in the penetration of the two bodies, just within the
sharp edge that leads. Such a node has passed through the leading face, but the face that slides over it is far nearer,
and opposes the node's own surface; that face takes the node over. The contact force stays the gradient of k g^2/2 with
g the least of the depths, and does no work on a closed path.

The condition on the node's own surface keeps a node in place that rests at the edge of a body, such as a corner of one of
two blocks that are stacked flush: its surface does not oppose the side of the block below. A node without a surface of
its own, such as a mass or the end of a beam, moves over the ridge where it is deeper than the segment extends beyond its
border (MAXPAR).
"""

from vmharness.explicit.contact.geometry import centre, corners, interpolate, shape, size
from vmharness.explicit.contact.records import Record
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, cross, dot, inlined, subtract, unit
from vmharness.explicit.state import Array, Index

OPPOSED = -0.5  # cosine between the normals of surfaces that face each other, at most
SHARP = 0.5  # cosine between the normals of segments at a ridge, at most


@uncounted
def crosses_ridge(
    # model
    x: Array, segment: Record, other: Record, own: Index, maxpar: float,
    # node, its height over `segment`, which is farther than the other
    node: Record, height: float, n: Vector,
    # projection on `other`: p - r, normal
    away: Vector, m: Vector,
) -> bool:  # fmt: skip
    """Whether a contact moves on from a segment over a ridge to the other, behind which the node is too."""
    if segment["two_sided"] or other["two_sided"] or height >= 0.0:
        return False
    convex = dot(subtract(midpoint(x, other), midpoint(x, segment)), n) < 0.0
    if dot(n, m) >= SHARP or dot(away, m) >= 0.0 or not convex:
        return False
    if node["own_from"] == node["own_to"]:
        return bool(-height > 0.5 * (maxpar - 1.0) * size(corners(x, segment["nodes"])))
    return bool(faces(own, x, node, m))


@inlined
def midpoint(x: Array, segment: Record) -> Vector:
    """The point at the centre of a segment."""
    xi, eta = centre(segment["triangle"])
    return interpolate(corners(x, segment["nodes"]), shape(segment["triangle"], xi, eta))


@uncounted
def faces(own: Index, x: Array, node: Record, m: Vector) -> bool:
    """Whether the node's own surface is opposed to a segment with the normal m."""
    for i in range(node["own_from"], node["own_to"]):
        c = corners(x, own[i])
        across = unit(cross(subtract(c[2], c[0]), subtract(c[3], c[1])))
        if dot(across, m) <= OPPOSED:
            return True
    return False
