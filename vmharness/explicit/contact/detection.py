"""First contact: a node that passes through a surface within the step, or comes within the thicknesses of it.

A segment with one side is touched by a node that was in front of it at t_{n-1} and is behind it at t_n, and whose path
between the two crosses it: the gap g falls through zero at the fraction g_{n-1} / (g_{n-1} - g_n) of the step, at a
point that lies on the segment. However deep it then is, none is missed; and a node that was behind all along is none.
A shell of an automatic contact is touched by a node nearer than (t_node + t_shell)/2, from the side where it was at
t_{n-1}, and by a node that has passed through all of it in one step.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.energy import catch
from vmharness.explicit.contact.geometry import (
    Corners,
    at,
    at_time,
    beyond,
    corners,
    interpolate,
    normal,
    project,
    shape,
)
from vmharness.explicit.contact.nearest_neighbour import SMOOTH, touched
from vmharness.explicit.contact.projection import first_guess, half_thickness, place
from vmharness.explicit.contact.records import MOST, Record, Records
from vmharness.explicit.contact.search import box, outside
from vmharness.explicit.contact.tracking import follow
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, cross, dot, inlined, scale, subtract
from vmharness.explicit.model.state import Array

Index = NDArray[np.intp]

ROUND_OFF = 1e-9  # of a segment: at the start, who is behind by no more is in contact
BEHIND = 0.01  # of the change of the gap: so far behind at t_{n-1} is round-off


@uncounted
def look(
    x: Array, v: Array, mass: Array, dt: float, step: float, node: Record, touches: Records, segments: Records,
    first: Index, beside: Index, near: Index, rule: Record, account: Array,
) -> float:  # fmt: skip
    """Add what a node touches newly, of the segments `near` it; return how far it is from all others.

    `step` is the greatest relative motion within the step `dt`.
    """
    p, least = at(x, node["row"]), np.inf
    maxpar, start, easing = rule["maxpar"], rule["start"], rule["start"] and rule["ignore"]
    only = nearest(x, node, segments, near) if easing else -1
    for s in near:
        if easing and s != only:  # an initial penetration is that of the nearest segment
            continue
        segment = segments[s]
        half = half_thickness(node, segment)
        low, high = box(x, segment)
        bound = outside(p, low, high) - half
        if (bound > step and bound >= least and not start) or touched(touches, s, node["count"]):
            continue
        guess_xi, guess_eta = first_guess(segment["triangle"])
        xi, eta, out, away, n = place(x, segment, p, guess_xi, guess_eta)
        free = np.sqrt(dot(away, away)) - half
        if again(x, segments, touches, node["count"], s, out > 0.0, n, first, beside):
            continue
        if (free <= step or start) and node["count"] < MOST:
            side = begins(x, v, dt, segment, node, p, xi, eta, free, maxpar, start, easing)
            if side != 0.0 and hold(x, node, touches, s, side, xi, eta, segments, first, beside, maxpar):
                if easing:
                    touches[node["count"] - 1]["ease"] = -touches[node["count"] - 1]["gap"]
                else:
                    catch(x, v, mass, dt, node, segments, touches[node["count"] - 1], rule, account)
                continue
        least = min(least, max(free, 0.0))
    return least


@uncounted
def nearest(x: Array, node: Record, segments: Records, near: Index) -> int:
    """The one of the segments `near` a node that is nearest to it, or -1."""
    best, least, p = -1, np.inf, at(x, node["row"])
    for s in near:
        xi, eta = first_guess(segments[s]["triangle"])
        _, _, _, away, _ = place(x, segments[s], p, xi, eta)
        if dot(away, away) < least:
            best, least = s, dot(away, away)
    return best


@uncounted
def again(
    x: Array, segments: Records, touches: Records, count: int, s: int, at_edge: bool, n: Vector,
    first: Index, beside: Index,
) -> bool:  # fmt: skip
    """Whether segment s continues a surface that the node touches: beside it, smoothly or nearest at its border."""
    for k in range(count):
        r = touches[k]["segment"]
        for e in range(first[r], first[r + 1]):
            if beside[e] == s:
                c = corners(x, segments[r]["nodes"])
                cosine = dot(n, normal(segments[r]["triangle"], c, touches[k]["xi"], touches[k]["eta"]))
                if at_edge or (abs(cosine) if segments[s]["two_sided"] else cosine) >= SMOOTH:
                    return True
    return False


@uncounted
def hold(
    x: Array, node: Record, touches: Records, s: int, side: float, xi: float, eta: float, segments: Records,
    first: Index, beside: Index, maxpar: float,
) -> bool:  # fmt: skip
    """Add a touch of segment s; False where the node is not within reach of it after all."""
    k = node["count"]
    touch = touches[k]
    touch["segment"], touch["side"], touch["xi"], touch["eta"] = s, side, xi, eta
    touch["ease"], touch["shear"] = 0.0, 0.0
    for j in range(3):
        touch["slip"][j] = 0.0
        touch["force"][j] = 0.0
    found = follow(x, node, touches, k, segments, first, beside, maxpar)
    if found:
        node["count"] += 1
    return bool(found)


@uncounted
def begins(
    x: Array, v: Array, dt: float, segment: Record, node: Record, p: Vector, xi: float, eta: float, free: float,
    maxpar: float, start: bool, easing: bool,
) -> float:  # fmt: skip
    """The side from which contact begins now: 1 in front, -1 behind, 0 where it does not begin."""
    nodes, triangle, half = segment["nodes"], segment["triangle"], half_thickness(node, segment)
    c = corners(x, nodes)
    xi, eta, now = gap(triangle, c, p, xi, eta)
    if start:
        if segment["two_sided"]:
            return (1.0 if now >= 0.0 else -1.0) if free < 0.0 else 0.0
        behind = now < half and (easing or half - now <= ROUND_OFF * size(c))
        return 1.0 if behind and beyond(triangle, xi, eta) <= maxpar - 1.0 else 0.0

    back = at_time(c, corners(v, nodes), dt)
    old_xi, old_eta, old = gap(triangle, back, subtract(p, scale(dt, at(v, node["row"]))), xi, eta)
    side = 1.0
    if segment["two_sided"]:
        side = 1.0 if old >= 0.0 else -1.0
        if free < 0.0:
            return side
        half = 0.0  # or it has passed through the middle
    old, now = side * old - half, side * now - half
    if now >= 0.0 or old < -BEHIND * abs(old - now):
        return 0.0
    along = min(max(old / (old - now), 0.0), 1.0)
    crossing = beyond(triangle, old_xi + along * (xi - old_xi), old_eta + along * (eta - old_eta))
    return side if crossing <= maxpar - 1.0 else 0.0


@inlined
def gap(triangle: bool, c: Corners, p: Vector, xi: float, eta: float) -> tuple[float, float, float]:
    """xi, eta of the projection of p on the segment and its continuation, and the height over it."""
    xi, eta = project(triangle, c, p, xi, eta)
    n = normal(triangle, c, xi, eta)
    return xi, eta, dot(subtract(p, interpolate(c, shape(triangle, xi, eta))), n)


@inlined
def size(c: Corners) -> float:
    """The square root of twice the area."""
    area = cross(subtract(c[2], c[0]), subtract(c[3], c[1]))
    return float(dot(area, area) ** 0.25)
