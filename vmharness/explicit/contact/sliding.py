"""Tracking of the touches that stay well within their segments, as most do: several at a time (kernels/simd.py).

Any other is left as it was, its node marked as unsettled, for `follow`.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.contact.geometry import CONVERGED, at, beyond, corners, newton, polynomial
from vmharness.explicit.contact.projection import half_thickness
from vmharness.explicit.contact.records import Record, Records, write
from vmharness.explicit.kernels.compiled import uncounted
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import add, cross, dot, inlined, scale, subtract, unit
from vmharness.explicit.model.state import Array

Index = NDArray[np.intp]

# Rows of the buffer: tangents r,xi and r,eta, their twist, p - r, the normal, and single numbers.
A, B, W, AWAY, N, XI, ETA, LEFT, LEAST = 0, 3, 6, 9, 12, 15, 16, 17, 18
ROWS = 19
STEPS = 3  # of Newton's method from the last contact point; who needs more is left


@uncounted
def slide(x: Array, nodes: Records, segments: Records, touches: Records, work: Array, lanes: Index) -> None:
    """Bring touches to t_n, and clear the forces of their nodes.

    `work (ROWS * LANES,)`, `lanes (LANES, 2)`: buffers.
    """
    count = 0
    for t in range(nodes.size):
        node = nodes[t]
        if node["count"] == 0:
            continue
        node["settled"] = True
        node["force"][0] = node["force"][1] = node["force"][2] = 0.0
        for k in range(node["count"]):
            lay(x, node, touches[k, t], segments, work, count)
            lanes[count, 0], lanes[count, 1] = k, t
            count += 1
            if count == LANES:
                closest(work)
                take(nodes, segments, touches, work, lanes, count)
                count = 0
    if count > 0:
        closest(work)
        take(nodes, segments, touches, work, lanes, count)


@inlined
def lay(x: Array, node: Record, touch: Record, segments: Records, work: Array, e: int) -> None:
    """The segment and the node against it, at the contact point of t_{n-1}, into lane e."""
    segment, xi, eta = segments[touch["segment"]], touch["xi"], touch["eta"]
    o, a, b, w = polynomial(segment["triangle"], corners(x, segment["nodes"]))
    along = add(a, scale(eta, w))
    put(work, A, e, along)
    put(work, B, e, add(b, scale(xi, w)))
    put(work, W, e, w)
    put(work, AWAY, e, subtract(at(x, node["row"]), add(o, add(scale(eta, b), scale(xi, along)))))
    work[XI * LANES + e], work[ETA * LANES + e] = xi, eta


@uncounted
def closest(work: Array) -> None:
    """The closest point, p - r and the normal there, and what the last step has left."""
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
def take(nodes: Records, segments: Records, touches: Records, work: Array, lanes: Index, count: int) -> None:
    """Keep what was found of the touches of the first `count` lanes that stay where they are."""
    for e in range(count):
        k, t = lanes[e, 0], lanes[e, 1]
        node, touch = nodes[t], touches[k, t]
        segment, side = segments[touch["segment"]], touch["side"]
        xi, eta, away, n = (
            work[XI * LANES + e],
            work[ETA * LANES + e],
            vector(work, AWAY, e),
            vector(work, N, e),
        )
        out, gap = beyond(segment["triangle"], xi, eta), side * dot(away, n) - half_thickness(node, segment)
        inside = out < 0.0 and out * out * work[LEAST * LANES + e] > dot(away, away)
        if inside and work[LEFT * LANES + e] <= CONVERGED and gap < 0.0 and -gap <= segment["release"]:
            write(touch, touch["segment"], side, xi, eta, scale(side, n), gap)
        else:
            node["settled"] = False
