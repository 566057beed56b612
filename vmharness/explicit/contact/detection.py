"""Detection of new contacts: a node crosses a surface within the step, or comes within the thicknesses of it.

Contact with a one-sided segment begins where a node was in front of it at t_{n-1} and is behind it at t_n, and its path
crosses the segment: the gap g is zero at the fraction g_{n-1} / (g_{n-1} - g_n) of the step, at a point that lies on
the segment. However deep the node then is, it is not missed; a node that was behind all along is not in contact.
Contact with a shell in an automatic contact begins where a node is nearer than (t_node + t_shell)/2, on the side where
it was at t_{n-1}, or has passed through the whole shell in one step.
"""

import numpy as np

from vmharness.explicit.contact.energy import account_activation
from vmharness.explicit.contact.geometry import at, at_time, beyond, centre, corners, normal, shape, size
from vmharness.explicit.contact.kinematics import relative
from vmharness.explicit.contact.neighbours import SMOOTH
from vmharness.explicit.contact.projection import half_thickness, height_over, project_node
from vmharness.explicit.contact.records import MAX_CONTACTS, Record, Records, is_active
from vmharness.explicit.contact.search import bounding_box, distance_to_box, nearest_segment
from vmharness.explicit.contact.tracking import HELD, MAX_CROSSINGS, track
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, dot, scale, subtract
from vmharness.explicit.state import Array, Index

ROUND_OFF = 1e-9  # of a segment: in the first cycle, a node that is behind by no more is in contact
BEHIND = 0.01  # of the change of the gap: a node that was behind by no more at t_{n-1} was so by round-off


@uncounted
def detect(
    # model
    mass: Array, segments: Records, first: Index, neighbours: Index, candidates: Index, own: Index, parameters: Record,
    # motion; `step` bounds the relative motion within the step
    x: Array, v: Array, dt: float, step: float,
    # updated
    node: Record, states: Records, account: Array,
) -> float:  # fmt: skip
    """Activate new contacts of a node among its candidate segments; return its clearance to the nearest inactive one.

    Count the cycles in which it needs more than MAX_CONTACTS.
    """
    p, least, full = at(x, node["row"]), np.inf, False
    maxpar, start = parameters["maxpar"], parameters["first_cycle"]
    ignore = start and parameters["ignore"]
    only = nearest_segment(segments, candidates, x, node) if ignore else -1
    for s in candidates:
        if ignore and s != only:  # an initial penetration is that of the nearest segment
            continue
        segment = segments[s]
        half = half_thickness(node, segment)
        low, high = bounding_box(x, segment)
        bound = distance_to_box(p, low, high) - half
        if (bound > step and bound >= least and not start) or is_active(states, s, node["count"]):
            continue
        guess_xi, guess_eta = centre(segment["triangle"])
        xi, eta, out, away, n = project_node(x, segment, p, guess_xi, guess_eta)
        free = np.sqrt(dot(away, away)) - half
        if is_continuation(segments, first, neighbours, x, states, node["count"], s, out > 0.0, n):
            continue
        if free <= step or start:
            moved = relative(v, node["row"], segment, shape(segment["triangle"], xi, eta))
            reach = 0.0 if start else dt * abs(dot(moved, n))
            side = crosses(segment, maxpar, x, v, dt, start, ignore, node, p, xi, eta, free)
            if side != 0.0 and node["count"] == MAX_CONTACTS:
                full = True
            elif side != 0.0 and activate(
                segments, first, neighbours, own, maxpar, x, reach, s, side, xi, eta, node, states
            ):
                new = states[node["count"] - 1]
                if ignore:
                    new["offset"] = -new["gap"]
                else:
                    account_activation(mass, segments, parameters, v, dt, node, new, account)
                continue
        least = min(least, max(free, 0.0))
    if full:
        node["full_cycles"] += 1
    return least


@uncounted
def is_continuation(
    # model
    segments: Records, first: Index, neighbours: Index,
    # active contacts
    x: Array, states: Records, count: int,
    # projection on segment s
    s: int, at_edge: bool, n: Vector,
) -> bool:  # fmt: skip
    """Whether segment s continues a surface in contact: next to it, joined smoothly or nearest at its border."""
    for k in range(count):
        r = states[k]["segment"]
        for e in range(first[r], first[r + 1]):
            if neighbours[e] == s:
                c = corners(x, segments[r]["nodes"])
                cosine = dot(n, normal(segments[r]["triangle"], c, states[k]["xi"], states[k]["eta"]))
                if at_edge or (abs(cosine) if segments[s]["two_sided"] else cosine) >= SMOOTH:
                    return True
    return False


@uncounted
def activate(
    # model
    segments: Records, first: Index, neighbours: Index, own: Index, maxpar: float,
    # motion, new contact point
    x: Array, reach: float, s: int, side: float, xi: float, eta: float,
    # updated
    node: Record, states: Records,
) -> bool:  # fmt: skip
    """Add a contact with segment s; return False where tracking finds the node out of reach."""
    k = node["count"]
    state = states[k]
    state["segment"], state["side"], state["xi"], state["eta"] = s, side, xi, eta
    state["offset"], state["shear"] = 0.0, 0.0
    for j in range(3):
        state["slip"][j] = 0.0
        state["force"][j] = 0.0
    for _ in range(MAX_CROSSINGS):
        then = track(segments, first, neighbours, own, maxpar, x, reach, node, states, k)
        if then < 0:
            break
        state["segment"], state["side"], reach = then, 1.0, -1.0  # over a ridge
        state["xi"], state["eta"] = centre(segments[then]["triangle"])
    if then == HELD:
        node["count"] += 1
    return bool(then == HELD)


@uncounted
def crosses(
    # model
    segment: Record, maxpar: float,
    # motion
    x: Array, v: Array, dt: float, start: bool, ignore: bool,
    # node at p, its closest point, and distance less half the thicknesses
    node: Record, p: Vector, xi: float, eta: float, free: float,
) -> float:  # fmt: skip
    """The side on which contact begins at t_n: 1 in front, -1 behind, 0 where it does not begin."""
    nodes, triangle, half = segment["nodes"], segment["triangle"], half_thickness(node, segment)
    c = corners(x, nodes)
    xi, eta, now, _ = height_over(triangle, c, p, xi, eta)
    if start:
        if segment["two_sided"]:
            return (1.0 if now >= 0.0 else -1.0) if free < 0.0 else 0.0
        behind = now < half and (ignore or half - now <= ROUND_OFF * size(c))
        return 1.0 if behind and beyond(triangle, xi, eta) <= maxpar - 1.0 else 0.0

    back = at_time(c, corners(v, nodes), dt)
    before = subtract(p, scale(dt, at(v, node["row"])))
    old_xi, old_eta, old, _ = height_over(triangle, back, before, xi, eta)
    side = 1.0
    if segment["two_sided"]:
        side = 1.0 if old >= 0.0 else -1.0
        if free < 0.0:
            return side
        half = 0.0  # or it has passed through the mid-surface
    old, now = side * old - half, side * now - half
    if now >= 0.0 or old < -BEHIND * abs(old - now):
        return 0.0
    along = min(max(old / (old - now), 0.0), 1.0)
    crossing = beyond(triangle, old_xi + along * (xi - old_xi), old_eta + along * (eta - old_eta))
    return side if crossing <= maxpar - 1.0 else 0.0
