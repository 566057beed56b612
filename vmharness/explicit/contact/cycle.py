"""One cycle of a pass of nodes against segments.

What a node can touch is found by sorting (`bucket`), with a margin, and stays all that it can touch until nodes and
segments have moved against each other by that margin. Their motion is bounded by the ranges of their velocities, summed
over the steps; with it, each node keeps the distance to the nearest segment that it does not touch, and is not looked
at before that can have been used up.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.detection import look
from vmharness.explicit.contact.energy import half_work, let_go
from vmharness.explicit.contact.force import push
from vmharness.explicit.contact.geometry import at
from vmharness.explicit.contact.records import Record, Records
from vmharness.explicit.contact.sliding import slide
from vmharness.explicit.contact.tracking import follow
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.vector import Vector, dot, inlined, subtract
from vmharness.explicit.model.state import Array

Index = NDArray[np.intp]

REACH = 1.01  # so that a node which begins to fall from the surface itself is not missed by round-off


@uncounted
def cycle(
    f: Array, x: Array, v: Array, a: Array, mass: Array, dt: float, nodes: Records, segments: Records,
    touches: Records, first: Index, beside: Index, near_first: Index, near: Index, rows: Index,
    rules: Records, account: Array, work: Array, lanes: Index, sorted_now: bool,
) -> bool:  # fmt: skip
    """Add contact forces at t_n, and the work of the step; False, and nothing done, where a sort must come first.

    `account` receives the energies "contact" and "friction", the sum of forces on the nodes, and the energy
    "released"; `work`, `lanes`: buffers of `slide`.
    """
    rule = rules[0]
    step = REACH * dt * fastest(v, nodes, rows)
    travel = 0.0 if sorted_now else rule["travel"] + step
    if travel > rule["margin"]:
        return False
    rule["travel"], rule["longest"] = travel, max(rule["longest"], dt)
    account[2:5] = 0.0
    # Several loops, since the work on several nodes overlaps in the processor only where a loop is short.
    for t in range(nodes.size):
        for k in range(nodes[t]["count"]):
            half_work(x, v, dt, nodes[t], segments, touches[k, t], rule, account)
    slide(x, nodes, segments, touches, work, lanes)
    for t in range(nodes.size):
        node = nodes[t]
        if (node["settled"] or node["count"] == 0) and node["clear"] > travel and not sorted_now:
            continue
        own = touches[:, t]
        if keep_up(x, v, dt, node, own, segments, first, beside, rule["maxpar"], account) or sorted_now:
            node["clear"] = 0.0
        if node["clear"] <= travel:
            candidates = near[near_first[t] : near_first[t + 1]]
            node["clear"] = travel + look(
                x, v, mass, dt, step, node, own, segments, first, beside, candidates, rule, account,
            )  # fmt: skip
    for t in range(nodes.size):
        for k in range(nodes[t]["count"]):
            push(f, x, v, a, mass, dt, nodes[t], segments, touches[k, t], rule, account)
    rule["start"] = False
    return True


@inlined
def keep_up(
    x: Array, v: Array, dt: float, node: Record, touches: Records, segments: Records, first: Index, beside: Index,
    maxpar: float, account: Array,
) -> bool:  # fmt: skip
    """Follow all touches of a node; True where one has moved to another segment or let go."""
    changed, k = False, 0
    while k < node["count"]:
        segment = touches[k]["segment"]
        if follow(x, node, touches, k, segments, first, beside, maxpar):
            changed = changed or touches[k]["segment"] != segment
            k += 1
        else:
            changed = True
            let_go(x, v, dt, node, segments, touches[k], account)
            node["count"] -= 1
            for later in range(k, node["count"]):
                touches[later] = touches[later + 1]
    return changed


@uncounted
def rest(
    x: Array, v: Array, dt: float, nodes: Records, segments: Records, touches: Records, rules: Records, account: Array
) -> None:  # fmt: skip
    """Let all nodes go at t_n, as a contact does that ends, and add the work of the step that led to it."""
    account[2:5] = 0.0
    for t in range(nodes.size):
        node = nodes[t]
        for k in range(node["count"]):
            half_work(x, v, dt, node, segments, touches[k, t], rules[0], account)
            let_go(x, v, dt, node, segments, touches[k, t], account)
        node["count"] = 0
        node["force"][0] = node["force"][1] = node["force"][2] = 0.0


@uncounted
def fastest(v: Array, nodes: Records, rows: Index) -> float:
    """A bound of the relative velocity of any of the nodes and any of the `rows` of segments."""
    low = high = at(v, rows[0])
    for r in rows:
        here = at(v, r)
        low, high = lower(low, here), higher(high, here)
    least = most = at(v, nodes[0]["row"])
    for t in range(nodes.size):
        here = at(v, nodes[t]["row"])
        least, most = lower(least, here), higher(most, here)
    bound = higher(subtract(most, low), subtract(high, least))
    return float(np.sqrt(dot(bound, bound)))


@inlined
def lower(a: Vector, b: Vector) -> Vector:
    """The lesser of each component."""
    return min(a[0], b[0]), min(a[1], b[1]), min(a[2], b[2])


@inlined
def higher(a: Vector, b: Vector) -> Vector:
    """The greater of each component."""
    return max(a[0], b[0]), max(a[1], b[1]), max(a[2], b[2])
