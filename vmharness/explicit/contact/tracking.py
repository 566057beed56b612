"""Tracking: how a node in contact slides over the segments of a surface, crosses borders and leaves contact.

The contact point is the closest point of the surface, found from the last one: within the segment, on its border, or on
a neighbour that is nearer. The force derives from the potential k g^2 / 2 of the distance, so it does not jump where
segments join flat, and does no work on a closed path where they join at an angle. A node behind two walls of a valley
is nearest to the edge between them: both walls push it, since (a^2 + b^2)/2 is the potential of both. For a node
behind it, a ridge of more than 60 degrees ends the surface, except where the node's own surface faces the other side
of the ridge, and that side is nearer (ridge.py).

Beyond the end of the surface, a node behind it stays in contact up to MAXPAR, and a node in front of a shell, within
the thicknesses, is in contact with the edge itself, which is round.
"""

import numpy as np

from vmharness.explicit.contact.geometry import at, beyond, centre, corners, tangents
from vmharness.explicit.contact.neighbours import nearest_neighbour
from vmharness.explicit.contact.projection import half_thickness, height_over, is_inside, project_node
from vmharness.explicit.contact.records import Record, Records, is_active, write
from vmharness.explicit.contact.ridge import OUTSIDE, over_ridge
from vmharness.explicit.kernels.vector import Vector, dot, inlined, scale
from vmharness.explicit.state import Array, Index

MAX_CROSSINGS = 4  # borders crossed in one step
HELD, ENDED = -1, -2  # the contact goes on; it has ended


@inlined
def track(
    # model
    segments: Records, first: Index, neighbours: Index, own: Index, maxpar: float,
    # motion; how far a new contact has come in this step, negative if it has just crossed a ridge
    x: Array, reach: float,
    # node, and which of its contacts; updated
    node: Record, states: Records, k: int,
) -> int:  # fmt: skip
    """Update segment, contact point, normal and gap of contact k of a node at t_n.

    Return HELD; or ENDED; or the segment beyond a ridge that takes the node over, where this contact ends.
    """
    state, p = states[k], at(x, node["row"])
    s, side, xi, eta = state["segment"], state["side"], state["xi"], state["eta"]
    shared = False
    xi, eta, out, away, n = project_node(x, segments[s], p, xi, eta)
    for crossing in range(MAX_CROSSINGS):
        inside = is_inside(out, tangent_square(x, segments[s], xi, eta), away)
        if reach > 0.0 or (reach == 0.0 and not inside):
            height = side * dot(away, n)
            across = over_ridge(segments, first, neighbours, own, maxpar, x, node, s, height, n, reach)
            if across == OUTSIDE or (across >= 0 and is_active(states, across, node["count"])):
                return ENDED
            if across >= 0:
                return across
        if inside:
            break
        other, turn, shared = nearest_neighbour(
            segments, first, neighbours, x, node, states, s, side, out, away, n
        )
        if other < 0:
            break
        s, side = other, side * turn
        state["segment"] = s
        xi, eta = centre(segments[s]["triangle"])
        xi, eta, out, away, n = project_node(x, segments[s], p, xi, eta)
        if crossing == MAX_CROSSINGS - 1:
            node["long_slides"] = min(node["long_slides"] + 1, 65535)
            shared = False  # it was that of the segment before

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
            xi, eta, out, height, n = project_on_continuation(x, segment, p, xi, eta, side)
            if out > maxpar - 1.0:
                return ENDED
        n = scale(side, n)
    gap = height - half_thickness(node, segment)
    if -gap > segment["release"]:
        node["released"] = True
        return ENDED
    if gap >= 0.0:
        return ENDED
    write(state, s, side, xi, eta, n, gap)
    return HELD


@inlined
def tangent_square(x: Array, segment: Record, xi: float, eta: float) -> float:
    """The lesser of r,xi . r,xi and r,eta . r,eta."""
    a, b = tangents(segment["triangle"], corners(x, segment["nodes"]), xi, eta)
    return min(dot(a, a), dot(b, b))


@inlined
def project_on_continuation(
    x: Array, segment: Record, p: Vector, xi: float, eta: float, side: float
) -> tuple[float, float, float, float, Vector]:
    """xi, eta on the segment continued beyond its border; how far beyond; height on `side`; the normal."""
    c, triangle = corners(x, segment["nodes"]), segment["triangle"]
    xi, eta, height, n = height_over(triangle, c, p, xi, eta)
    return xi, eta, beyond(triangle, xi, eta), side * height, n
