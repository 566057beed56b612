"""Vector instructions (SIMD): the nodal values of several elements are stored side by side.

A stage of a step works on LANES elements at a time. Row r of element e is work[r * LANES + e] in one flat buffer. With
constant offsets into one array the compiler knows that rows do not overlap, and makes vector instructions of every loop
over e. Arrays of element quantities have the same order. The vectors of nodes have consecutive rows: node 1 x, y, z,
node 2 x, y, z, ...
"""

import numpy as np

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.vector import Vector, inlined
from vmharness.explicit.state import Array, Index

LANES = 16  # LLVM does not vectorise shorter loops if it has to check whether arrays overlap


@inlined
def vector(work: Array, row: int, e: int) -> Vector:
    """The vector in three rows of element e."""
    return work[row * LANES + e], work[(row + 1) * LANES + e], work[(row + 2) * LANES + e]


@inlined
def put(work: Array, row: int, e: int, a: Vector) -> None:
    """Store a vector in three rows of element e."""
    work[row * LANES + e] = a[0]
    work[(row + 1) * LANES + e] = a[1]
    work[(row + 2) * LANES + e] = a[2]


@kernel
def gather(field: Array, nodes: Index, work: Array, row: int) -> None:
    """Copy the vectors of a field (n, 3) at the `nodes` (corners * LANES,) into the buffer."""
    for e in range(LANES):
        for i in range(nodes.size // LANES):
            node = nodes[i * LANES + e]
            for k in range(3):
                work[(row + 3 * i + k) * LANES + e] = field[node, k]


@kernel
def scatter(field: Array, nodes: Index, count: int, work: Array, row: int) -> None:
    """Subtract internal forces (or moments) from a field (n, 3), in the order of elements: sums are reproducible."""
    for e in range(count):
        for i in range(nodes.size // LANES):
            node = nodes[i * LANES + e]
            for k in range(3):
                field[node, k] -= work[(row + 3 * i + k) * LANES + e]


def by_block(a: Array) -> Array:
    """Rearrange (ne, ..., k) to (blocks, ..., k rows of LANES); the last element is repeated to fill its block.

    >>> by_block(np.array([[1.0, 2.0], [3.0, 4.0]]))[:, [0, 1, LANES, LANES + 1]]
    array([[1., 3., 2., 4.]])
    """
    filled = np.concatenate([a, np.repeat(a[-1:], -len(a) % LANES, axis=0)])
    blocks = len(filled) // LANES
    by_lane = np.moveaxis(filled.reshape(blocks, LANES, *a.shape[1:]), 1, -1)
    return np.ascontiguousarray(by_lane.reshape(blocks, *a.shape[1:-1], a.shape[-1] * LANES))


def by_element(a: Array, elements: int) -> Array:
    """Rearrange (blocks, ..., k rows of LANES) back to (ne, ..., k)."""
    by_lane = np.moveaxis(a.reshape(*a.shape[:-1], a.shape[-1] // LANES, LANES), -1, 1)
    return by_lane.reshape(-1, *by_lane.shape[2:])[:elements]
