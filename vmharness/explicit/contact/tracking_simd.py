"""Tracking of contacts that stay well within their segments, as most do: LANES at a time (kernels/simd.py).

Any other contact is left unchanged, and its node marked as not settled: `track` updates it.
"""

import numpy as np

from vmharness.explicit.contact.geometry import at, beyond, corners, start
from vmharness.explicit.contact.projection import CONVERGED, half_thickness, is_inside, newton
from vmharness.explicit.contact.records import Record, Records, write
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import cross, dot, inlined, scale, unit
from vmharness.explicit.state import Array, Index

# Rows of the buffer: tangents r,xi and r,eta, their twist, p - r, the normal, and single numbers.
A, B, W, AWAY, N, XI, ETA, LEFT, LEAST = 0, 3, 6, 9, 12, 15, 16, 17, 18
ROWS = 19
STEPS = 3  # of Newton's method from the last contact point; a contact that needs more is left to `track`


def buffers() -> tuple[Array, Index]:
    """`work` (ROWS * LANES,) and `lanes` (LANES, 2), contact and node of each lane; unused lanes have a unit square."""
    work = np.zeros((ROWS, LANES))
    work[A] = work[B + 1] = 1.0
    return work.ravel(), np.zeros((LANES, 2), np.intp)


@uncounted
def track_settled(
    # model, motion
    segments: Records, x: Array,
    # updated
    nodes: Records, states: Records,
    # buffers
    work: Array, lanes: Index,
) -> None:  # fmt: skip
    """Update contacts to t_n, and clear the forces on their nodes."""
    count = 0
    for t in range(nodes.size):
        node = nodes[t]
        if node["count"] == 0:
            continue
        node["settled"] = True
        node["force"][0] = node["force"][1] = node["force"][2] = 0.0
        for k in range(node["count"]):
            load(x, node, states[k, t], segments, work, count)
            lanes[count, 0], lanes[count, 1] = k, t
            count += 1
            if count == LANES:
                project_lanes(work)
                store(segments, nodes, states, work, lanes, count)
                count = 0
    if count > 0:
        project_lanes(work)
        store(segments, nodes, states, work, lanes, count)


@inlined
def load(x: Array, node: Record, state: Record, segments: Records, work: Array, e: int) -> None:
    """Load the segment, and the node relative to it at the contact point of t_{n-1}, into lane e."""
    segment, xi, eta = segments[state["segment"]], state["xi"], state["eta"]
    a, b, w, away = start(segment["triangle"], corners(x, segment["nodes"]), at(x, node["row"]), xi, eta)
    put(work, A, e, a)
    put(work, B, e, b)
    put(work, W, e, w)
    put(work, AWAY, e, away)
    work[XI * LANES + e], work[ETA * LANES + e] = xi, eta


@uncounted
def project_lanes(work: Array) -> None:
    """Find the closest point of each lane, p - r and the normal there, and the error that the last step has left."""
    for e in range(LANES):
        a, b, w, away = vector(work, A, e), vector(work, B, e), vector(work, W, e), vector(work, AWAY, e)
        xi, eta, left = work[XI * LANES + e], work[ETA * LANES + e], 0.0
        for _ in range(STEPS):
            xi, eta, a, b, away, left = newton(xi, eta, a, b, w, away)
        put(work, AWAY, e, away)
        put(work, N, e, unit(cross(a, b)))
        work[XI * LANES + e], work[ETA * LANES + e], work[LEFT * LANES + e] = xi, eta, left
        work[LEAST * LANES + e] = min(dot(a, a), dot(b, b))


@inlined
def store(segments: Records, nodes: Records, states: Records, work: Array, lanes: Index, count: int) -> None:
    """Store the contacts of the first `count` lanes that stay within their segments; mark the nodes of the others."""
    for e in range(count):
        k, t = lanes[e, 0], lanes[e, 1]
        node, state = nodes[t], states[k, t]
        segment, side = segments[state["segment"]], state["side"]
        xi, eta = work[XI * LANES + e], work[ETA * LANES + e]
        away, n = vector(work, AWAY, e), vector(work, N, e)
        out, gap = beyond(segment["triangle"], xi, eta), side * dot(away, n) - half_thickness(node, segment)
        within = is_inside(out, work[LEAST * LANES + e], away)
        if within and work[LEFT * LANES + e] <= CONVERGED and gap < 0.0 and -gap <= segment["release"]:
            write(state, state["segment"], side, xi, eta, scale(side, n), gap)
        else:
            node["settled"] = False
