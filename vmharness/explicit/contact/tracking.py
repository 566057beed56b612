"""Tracking: how a node in contact slides over the segments of a surface, crosses borders and lets go.

The contact point is the closest point of the surface, found from the last one: within the segment, on its border, or on
a neighbour that is nearer. Force derives from the potential k g^2 / 2 of the distance, so it does not jump where
segments join flat, and does no work on a round trip where they join at an angle. A node behind two walls of a valley is
nearest to the edge between them: it is pushed by both, since (a^2 + b^2)/2 is the potential of both. The surface ends
where segments join by a ridge of more than 60 degrees, for a node behind it: the other side of a sharp edge is not
where it came from.

Beyond the end of the surface, a node behind it is kept up to MAXPAR, and a node in front of a shell, within the
thicknesses, is kept by the edge itself, which is round.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.geometry import (
    at,
    beyond,
    corners,
    interpolate,
    normal,
    project,
    shape,
    tangents,
)
from vmharness.explicit.contact.nearest_neighbour import nearer
from vmharness.explicit.contact.projection import first_guess, half_thickness, place
from vmharness.explicit.contact.records import Record, Records, write
from vmharness.explicit.kernels.vector import Vector, dot, inlined, scale, subtract
from vmharness.explicit.model.state import Array

Index = NDArray[np.intp]

HOPS = 4  # borders crossed within one step


@inlined
def follow(
    x: Array, node: Record, touches: Records, k: int, segments: Records, first: Index, beside: Index, maxpar: float
) -> bool:  # fmt: skip
    """Bring touch k of a node to t_n: segment, contact point, normal, gap; False, and these left, where it lets go."""
    touch, p = touches[k], at(x, node["row"])
    s, side, xi, eta = touch["segment"], touch["side"], touch["xi"], touch["eta"]
    shared = False
    for _ in range(HOPS):
        xi, eta, out, away, n = place(x, segments[s], p, xi, eta)
        if inside(x, segments[s], xi, eta, out, away):
            break
        other, turn, shared = nearer(x, node, touches, s, side, out, away, n, segments, first, beside)
        if other < 0:
            break
        s, side = other, side * turn
        touch["segment"] = s
        xi, eta = first_guess(segments[s]["triangle"])

    segment = segments[s]
    distance, height = np.sqrt(dot(away, away)), side * dot(away, n)
    if out > 0.0 and distance > 0.0 and (height >= 0.0 or (segment["two_sided"] and not shared)):
        n = scale(1.0 / distance, away)  # in front of an edge, which is round
        if height < 0.0:
            side = -side
        height = distance
    elif out > 0.0 and distance > 0.0 and shared:
        n = scale(-1.0 / distance, away)  # behind a valley
        height = -distance
    else:
        if out > 0.0:
            xi, eta, out, height, n = extended(x, segment, p, xi, eta, side)
            if out > maxpar - 1.0:
                return False
        n = scale(side, n)
    gap = height - half_thickness(node, segment)
    if -gap > segment["release"]:
        node["released"] = True
        return False
    if gap >= 0.0:
        return False
    write(touch, s, side, xi, eta, n, gap)
    return True


@inlined
def inside(x: Array, segment: Record, xi: float, eta: float, out: float, away: Vector) -> bool:
    """Whether the node is nearer to the segment than its border is, so that no neighbour is as near."""
    a, b = tangents(segment["triangle"], corners(x, segment["nodes"]), xi, eta)
    return bool(out < 0.0 and out * out * min(dot(a, a), dot(b, b)) > dot(away, away))


@inlined
def extended(
    x: Array, segment: Record, p: Vector, xi: float, eta: float, side: float
) -> tuple[float, float, float, float, Vector]:
    """xi, eta on the segment continued beyond its border; how far beyond; the height there; the normal."""
    c, triangle = corners(x, segment["nodes"]), segment["triangle"]
    xi, eta = project(triangle, c, p, xi, eta)
    n = normal(triangle, c, xi, eta)
    height = side * dot(subtract(p, interpolate(c, shape(triangle, xi, eta))), n)
    return xi, eta, beyond(triangle, xi, eta), height, n
