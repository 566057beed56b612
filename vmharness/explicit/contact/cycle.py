"""One cycle of a pass of tracked nodes against segments: energy, tracking, detection, force.

The candidate segments of each node are found by a bucket sort (search.py) with a margin, and suffice until nodes and
segments have moved relative to each other by that margin. The ranges of their velocities bound this motion; it is
summed over the steps. With it, each node keeps its clearance to the nearest inactive segment, and needs no detection
before the motion can have used that up.
"""

import numpy as np

from vmharness.explicit.contact.detection import activate, detect
from vmharness.explicit.contact.energy import account_activation, account_release, add_half_work
from vmharness.explicit.contact.force import add_contact_force
from vmharness.explicit.contact.geometry import at, centre
from vmharness.explicit.contact.records import FORCE, Record, Records
from vmharness.explicit.contact.tracking import HELD, track
from vmharness.explicit.contact.tracking_simd import track_settled
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, dot, inlined, subtract
from vmharness.explicit.state import Array, Index

REACH = 1.01  # so that round-off does not hide a node that begins to move from the surface itself


@uncounted
def cycle(
    # model
    mass: Array, segments: Records, first: Index, neighbours: Index, own: Index, rows: Index,
    # candidates
    candidate_first: Index, candidates: Index, sorted_now: bool,
    # motion
    x: Array, v: Array, a: Array, dt: float,
    # updated
    f: Array, nodes: Records, states: Records, pass_parameters: Records, account: Array,
    # buffers of `track_settled`
    work: Array, lanes: Index,
) -> bool:  # fmt: skip
    """Add contact forces at t_n and the work of the step; return False, with nothing done, where a sort is due.

    `account` receives the energies "contact", "friction" and "released", and the sum of forces on the tracked nodes.
    """
    parameters = pass_parameters[0]
    step = REACH * dt * relative_speed_bound(v, nodes, rows)
    travel = 0.0 if sorted_now else parameters["travel"] + step
    if travel > parameters["margin"]:
        return False
    parameters["travel"], parameters["longest_step"] = travel, max(parameters["longest_step"], dt)
    for j in range(3):
        account[FORCE + j] = 0.0
    # Several loops, since the work on several nodes overlaps in the processor only where a loop is short.
    for t in range(nodes.size):
        for k in range(nodes[t]["count"]):
            add_half_work(segments, parameters, x, v, dt, nodes[t], states[k, t], account)
    track_settled(segments, x, nodes, states, work, lanes)
    for t in range(nodes.size):
        node = nodes[t]
        if (node["settled"] or node["count"] == 0) and node["clearance"] > travel and not sorted_now:
            continue
        active = states[:, t]
        moved = track_all(mass, segments, first, neighbours, own, parameters, x, v, dt, node, active, account)
        if moved or sorted_now:
            node["clearance"] = 0.0
        if node["clearance"] <= travel:
            near = candidates[candidate_first[t] : candidate_first[t + 1]]
            node["clearance"] = travel + detect(
                mass, segments, first, neighbours, near, own, parameters,
                x, v, dt, step,
                node, active, account,
            )  # fmt: skip
    contacts = 0
    for t in range(nodes.size):
        contacts += nodes[t]["count"]
        for k in range(nodes[t]["count"]):
            add_contact_force(mass, segments, parameters, x, v, a, dt, f, nodes[t], states[k, t], account)
    parameters["first_cycle"], parameters["active"] = False, contacts
    return True


@inlined
def track_all(
    # model
    mass: Array, segments: Records, first: Index, neighbours: Index, own: Index, parameters: Record,
    # motion
    x: Array, v: Array, dt: float,
    # updated
    node: Record, states: Records, account: Array,
) -> bool:  # fmt: skip
    """Track all contacts of a node; return True where one has moved to another segment or ended."""
    maxpar, changed, k = parameters["maxpar"], False, 0
    while k < node["count"]:
        segment = states[k]["segment"]
        then = track(segments, first, neighbours, own, maxpar, x, 0.0, node, states, k)
        if then == HELD:
            changed = changed or states[k]["segment"] != segment
            k += 1
            continue
        changed = True
        account_release(segments, v, dt, node, states[k], account)
        node["count"] -= 1
        for later in range(k, node["count"]):
            states[later] = states[later + 1]
        if then >= 0:
            move_over_ridge(
                mass, segments, first, neighbours, own, parameters, x, v, dt, then, node, states, account
            )
    return changed


@uncounted
def move_over_ridge(
    # model
    mass: Array, segments: Records, first: Index, neighbours: Index, own: Index, parameters: Record,
    # motion, the segment beyond the ridge
    x: Array, v: Array, dt: float, s: int,
    # updated
    node: Record, states: Records, account: Array,
) -> None:  # fmt: skip
    """Begin the contact of a node with the segment that takes it over."""
    xi, eta = centre(segments[s]["triangle"])
    maxpar = parameters["maxpar"]
    if activate(segments, first, neighbours, own, maxpar, x, -1.0, s, 1.0, xi, eta, node, states):
        new = states[node["count"] - 1]
        account_activation(mass, segments, parameters, v, dt, node, new, account)


@uncounted
def deactivate(
    # model
    segments: Records, parameters: Records,
    # motion
    x: Array, v: Array, dt: float,
    # updated
    nodes: Records, states: Records, account: Array,
) -> None:  # fmt: skip
    """End all contacts at t_n, as at the death of the contact, and add the work of the step."""
    for j in range(3):
        account[FORCE + j] = 0.0
    for t in range(nodes.size):
        node = nodes[t]
        for k in range(node["count"]):
            add_half_work(segments, parameters[0], x, v, dt, node, states[k, t], account)
            account_release(segments, v, dt, node, states[k, t], account)
        node["count"] = 0
        node["force"][0] = node["force"][1] = node["force"][2] = 0.0


@uncounted
def relative_speed_bound(v: Array, nodes: Records, rows: Index) -> float:
    """An upper bound of the relative speed of any of the nodes and any of the `rows` of segments."""
    low = high = at(v, rows[0])
    for r in rows:
        here = at(v, r)
        low, high = minimum(low, here), maximum(high, here)
    least = most = at(v, nodes[0]["row"])
    for t in range(nodes.size):
        here = at(v, nodes[t]["row"])
        least, most = minimum(least, here), maximum(most, here)
    bound = maximum(subtract(most, low), subtract(high, least))
    return float(np.sqrt(dot(bound, bound)))


@inlined
def minimum(a: Vector, b: Vector) -> Vector:
    """The lesser of each component."""
    return min(a[0], b[0]), min(a[1], b[1]), min(a[2], b[2])


@inlined
def maximum(a: Vector, b: Vector) -> Vector:
    """The greater of each component."""
    return max(a[0], b[0]), max(a[1], b[1]), max(a[2], b[2])
