"""Tracking: how a node in contact slides over the segments of a surface, crosses borders and lets go.

The contact point is the closest point of the surface, found from the last one: within the segment, on its border, or on
a neighbour that is nearer. Force derives from the potential k g^2 / 2 of the distance, so it does not jump where
segments join flat, and does no work on a round trip where they join at an angle. Where segments meet by more than 60
degrees the surface is taken to end, for a node behind it: the other side of a sharp edge is not where it came from.

Beyond the end of the surface, a node behind it is kept up to MAXPAR, and a node in front of a shell, within the
thicknesses, is kept by the edge itself, which is round. A node that is held by two walls of a corner is kept by both.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.compiled import kernel
from vmharness.explicit.penalty.bucket import joins
from vmharness.explicit.penalty.place import first_guess, half_thickness, place
from vmharness.explicit.penalty.touch import Record, Records
from vmharness.explicit.segment import at, beyond, corners, interpolate, normal, project, shape, tangents
from vmharness.explicit.state import Array
from vmharness.explicit.vector import Vector, dot, inlined, scale, subtract

Index = NDArray[np.intp]

SMOOTH = 0.5  # cosine between normals of segments that are one surface
HOPS = 4  # borders crossed within one step
SAME = 1e-9  # of a distance: the point on a common border is equally near on both sides
CORNER = 0.5  # in xi and eta, beyond the border towards a wall that holds the node as well


@kernel
def follow(
    x: Array, node: Record, touches: Records, k: int, segments: Records, first: Index, beside: Index, maxpar: float
) -> bool:  # fmt: skip
    """Bring touch k of a node to t_n: segment, contact point, normal, gap; False where it has let go."""
    touch, p = touches[k], at(x, node["row"])
    s, side, xi, eta = touch["segment"], touch["side"], touch["xi"], touch["eta"]
    shared = False
    for _ in range(HOPS):
        xi, eta, out, away, n = place(x, segments[s], p, xi, eta)
        if inside(x, segments[s], xi, eta, out, away):
            break
        other, turn, shared = nearer(
            x, node, touches, k, s, side * dot(away, n), out, away, n, segments, first, beside
        )
        if other < 0:
            break
        s, side = other, side * turn
        xi, eta = first_guess(segments[s]["triangle"])

    distance, height = np.sqrt(dot(away, away)), side * dot(away, n)
    steep = abs(height) >= SMOOTH * distance
    segment = segments[s]
    if out > 0.0 and distance > 0.0 and (height >= 0.0 or (segment["two_sided"] and not (shared and steep))):
        n = scale(1.0 / distance, away)  # in front of an edge, which is round
        if height < 0.0 and segment["two_sided"]:
            side = -side
        height = distance
    elif out > 0.0 and distance > 0.0 and shared and steep:
        n = scale(-1.0 / distance, away)  # behind a valley between two segments
        height = -distance
    else:
        if out > 0.0:
            xi, eta, out, height, n = extended(x, segment, p, xi, eta, side)
            if out > maxpar - 1.0 and not (
                out < CORNER and held(touches, k, s, node["count"], first, beside)
            ):
                return False
        n = scale(side, n)
    write(touch, s, side, xi, eta, n, height - half_thickness(node, segment))
    return bool(touch["gap"] < 0.0 and -touch["gap"] <= segment["release"])


@inlined
def write(touch: Record, s: int, side: float, xi: float, eta: float, n: Vector, gap: float) -> None:
    """Keep what was found."""
    touch["segment"], touch["side"], touch["xi"], touch["eta"], touch["gap"] = s, side, xi, eta, gap
    touch["normal"][0], touch["normal"][1], touch["normal"][2] = n


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


@kernel
def nearer(
    x: Array, node: Record, touches: Records, k: int, s: int, height: float, out: float, away: Vector, n: Vector,
    segments: Records, first: Index, beside: Index,
) -> tuple[int, float, bool]:  # fmt: skip
    """The neighbour of s that is nearest, or -1 where s is; what it makes of the side; whether s shares its point."""
    p, best, turn, shared, least = at(x, node["row"]), -1, 1.0, False, dot(away, away)
    for e in range(first[s], first[s + 1]):
        q = beside[e]
        if joins(segments[q], node["row"]) or touched(touches, q, node["count"]):
            continue
        xi, eta = first_guess(segments[q]["triangle"])
        _, _, _, other, m = place(x, segments[q], p, xi, eta)
        cosine, two_sided = dot(n, m), segments[q]["two_sided"]
        round_edge = height >= 0.0 and out > 0.0 and (two_sided or dot(other, m) >= 0.0)
        if not round_edge and (abs(cosine) if two_sided else cosine) < SMOOTH:
            continue
        square = dot(other, other)
        shared = shared or square <= (1.0 + SAME) * dot(away, away)
        if square < (1.0 - SAME) * least:
            best, least = q, square
            flips = two_sided and (dot(other, m) * np.sign(height) < 0.0 if round_edge else cosine < 0.0)
            turn = -1.0 if flips else 1.0
    return best, turn, shared


@inlined
def touched(touches: Records, s: int, count: int) -> bool:
    """Whether the node touches segment s."""
    found = False
    for k in range(count):
        found = found or touches[k]["segment"] == s
    return found


@kernel
def held(touches: Records, k: int, s: int, count: int, first: Index, beside: Index) -> bool:
    """Whether the node touches a neighbour of segment s by another touch than k."""
    for other in range(count):
        if other != k:
            for e in range(first[s], first[s + 1]):
                if beside[e] == touches[other]["segment"]:
                    return True
    return False
