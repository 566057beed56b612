"""Bucket sort: find the candidate segments of each node, at a cost linear in the numbers of both.

Nodes are sorted into cubic cells as wide as a segment with its surroundings, and cells into a table by a hash of their
indices, so that distant nodes cost nothing. Each segment then searches the few cells that its surroundings reach.
"""

import numpy as np

from vmharness.explicit.contact.geometry import at, centre
from vmharness.explicit.contact.projection import project_node
from vmharness.explicit.contact.records import Record, Records
from vmharness.explicit.kernels.compiled import kernel, uncounted
from vmharness.explicit.kernels.vector import Vector, dot, inlined
from vmharness.explicit.state import Array, Index


@inlined
def bounding_box(x: Array, segment: Record) -> tuple[Vector, Vector]:
    """The least and the greatest coordinates of a segment."""
    c = segment["nodes"]
    a0, a1, a2 = at(x, c[0])
    b0, b1, b2 = a0, a1, a2
    for i in range(1, 4):
        p0, p1, p2 = at(x, c[i])
        a0, a1, a2 = min(a0, p0), min(a1, p1), min(a2, p2)
        b0, b1, b2 = max(b0, p0), max(b1, p1), max(b2, p2)
    return (a0, a1, a2), (b0, b1, b2)


@inlined
def distance_to_box(p: Vector, low: Vector, high: Vector) -> float:
    """The distance of p from a box; zero within."""
    d0 = max(low[0] - p[0], p[0] - high[0], 0.0)
    d1 = max(low[1] - p[1], p[1] - high[1], 0.0)
    d2 = max(low[2] - p[2], p[2] - high[2], 0.0)
    return float(np.sqrt(d0 * d0 + d1 * d1 + d2 * d2))


@inlined
def has_corner(segment: Record, row: int) -> bool:
    """Whether the node is a corner of the segment."""
    c = segment["nodes"]
    return bool(c[0] == row or c[1] == row or c[2] == row or c[3] == row)


@inlined
def table_place(i: int, j: int, k: int, mask: int) -> int:
    """Place of a cell in the hash table."""
    return (i * 73856093 ^ j * 19349663 ^ k * 83492791) & mask


@kernel
def mean_size(x: Array, segments: Records) -> float:
    """The mean over all segments of the longest side of their bounding box."""
    total = 0.0
    for s in range(segments.size):
        low, high = bounding_box(x, segments[s])
        total += max(high[0] - low[0], high[1] - low[1], high[2] - low[2])
    return total / segments.size


@kernel
def sort_into_cells(x: Array, nodes: Records, width: float, mask: int) -> tuple[Index, Index, Index]:
    """Find the cell (nt, 3) of each node; nodes order[start[b] : start[b + 1]] are those at place b of the table."""
    cells, place = np.empty((nodes.size, 3), np.intp), np.empty(nodes.size, np.intp)
    start = np.zeros(mask + 2, np.intp)
    for t in range(nodes.size):
        for j in range(3):
            cells[t, j] = np.intp(np.floor(x[nodes[t]["row"], j] / width))
        place[t] = table_place(cells[t, 0], cells[t, 1], cells[t, 2], mask)
        start[place[t] + 1] += 1
    start = np.cumsum(start)
    fill, order = start.copy(), np.empty(nodes.size, np.intp)
    for t in range(nodes.size):
        order[fill[place[t]]] = t
        fill[place[t]] += 1
    return cells, start, order


@inlined
def is_near(x: Array, node: Record, segment: Record, low: Vector, high: Vector, reach: float) -> bool:
    """Whether the node may be within `reach` of the surface of the segment, and is not one of its corners."""
    limit = reach + 0.5 * (node["thickness"] + segment["thickness"])
    return distance_to_box(at(x, node["row"]), low, high) <= limit and not has_corner(segment, node["row"])


@kernel
def find_candidates(x: Array, nodes: Records, segments: Records, reach: float) -> tuple[Index, Index]:
    """Find the segments within `reach` of each node t: found[first[t] : first[t + 1]], in increasing order."""
    thickest = 0.0
    for t in range(nodes.size):
        thickest = max(thickest, nodes[t]["thickness"])
    width = mean_size(x, segments) + 2.0 * (reach + thickest)
    mask = 1
    while mask < nodes.size:
        mask *= 2
    mask -= 1
    cells, start, order = sort_into_cells(x, nodes, width, mask)
    first, found = np.zeros(nodes.size + 1, np.intp), np.empty(0, np.intp)
    fill = first
    for sweep in range(2):  # count, then fill
        for s in range(segments.size):
            low, high = bounding_box(x, segments[s])
            around = reach + 0.5 * (thickest + segments[s]["thickness"])
            i0, i1 = np.floor((low[0] - around) / width), np.floor((high[0] + around) / width)
            j0, j1 = np.floor((low[1] - around) / width), np.floor((high[1] + around) / width)
            k0, k1 = np.floor((low[2] - around) / width), np.floor((high[2] + around) / width)
            every = (i1 - i0 + 1.0) * (j1 - j0 + 1.0) * (k1 - k0 + 1.0) > nodes.size
            if every:  # a segment much larger than the others: test all nodes
                i1, j1, k1 = i0, j0, k0
            for i in range(np.intp(i0), np.intp(i1) + 1):
                for j in range(np.intp(j0), np.intp(j1) + 1):
                    for k in range(np.intp(k0), np.intp(k1) + 1):
                        b = table_place(i, j, k, mask)
                        begin, end = (0, nodes.size) if every else (start[b], start[b + 1])
                        for n in range(begin, end):
                            t = n if every else order[n]
                            here = every or (cells[t, 0] == i and cells[t, 1] == j and cells[t, 2] == k)
                            if here and is_near(x, nodes[t], segments[s], low, high, reach):
                                if sweep == 0:
                                    first[t + 1] += 1
                                else:
                                    found[fill[t]] = s
                                    fill[t] += 1
        if sweep == 0:
            first = np.cumsum(first)
            found, fill = np.empty(first[-1], np.intp), first.copy()
    return first, found


@uncounted
def nearest_segment(segments: Records, candidates: Index, x: Array, node: Record) -> int:
    """The candidate segment that is nearest to a node, or -1."""
    best, least, p = -1, np.inf, at(x, node["row"])
    for s in candidates:
        xi, eta = centre(segments[s]["triangle"])
        _, _, _, away, _ = project_node(x, segments[s], p, xi, eta)
        if dot(away, away) < least:
            best, least = s, dot(away, away)
    return best
