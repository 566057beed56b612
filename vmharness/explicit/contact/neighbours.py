"""Which segments lie beside each other: a node that leaves one enters another."""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.compiled import kernel

Index = NDArray[np.intp]


@kernel
def neighbours(nodes: Index) -> tuple[Index, Index]:
    """For segments (ns, 4): those that share a node with segment s are found[first[s] : first[s + 1]], in order."""
    segments, rows = nodes.shape[0], nodes.max() + 1
    start = np.zeros(rows + 1, np.intp)
    for s in range(segments):
        for i in range(4):
            start[nodes[s, i] + 1] += 1
    start = np.cumsum(start)
    around = np.empty(4 * segments, np.intp)  # the segments around node r are around[start[r] : start[r + 1]]
    fill = start.copy()
    for s in range(segments):
        for i in range(4):
            around[fill[nodes[s, i]]] = s
            fill[nodes[s, i]] += 1

    first, found = np.zeros(segments + 1, np.intp), [0 for _ in range(0)]
    for s in range(segments):
        for i in range(4):
            for other in around[start[nodes[s, i]] : start[nodes[s, i] + 1]]:
                if other != s and other not in found[first[s] :]:
                    found.append(other)
        first[s + 1] = len(found)
    return first, np.array(found, np.intp)
