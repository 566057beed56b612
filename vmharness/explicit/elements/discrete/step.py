"""One step of the discrete elements of a part; arrays are of its elements (ne), vectors of nodes are (n, 3)."""

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.materials.spring_elastic import spring as law
from vmharness.explicit.state import Array
from vmharness.explicit.vector import Vector, add, dot, inlined, scale, subtract

Index = NDArray[np.intp]

PIECES = 1000  # of the way from the unloaded state to OFFSET


@inlined
def of_node(field: Array, node: int) -> Vector:
    """The vector of a node; zero for the ground, -1."""
    if node < 0:
        return 0.0, 0.0, 0.0
    return field[node, 0], field[node, 1], field[node, 2]


@inlined
def between(field: Array, ends: Index) -> Vector:
    """The vector of node 2 minus that of node 1."""
    return subtract(of_node(field, ends[1]), of_node(field, ends[0]))


@inlined
def axes(x: Array, v: Array, dt: float, ends: Index, direction: Array) -> tuple[Vector, Vector]:
    """The axis e_n, and the m along which rates are measured; a `direction` of zero follows the nodes."""
    fixed = (direction[0], direction[1], direction[2])
    if dot(fixed, fixed) > 0.0:
        return fixed, fixed
    now = between(x, ends)
    before = subtract(now, scale(dt, between(v, ends)))
    length_now, length_before = np.sqrt(dot(now, now)), np.sqrt(dot(before, before))
    return scale(1.0 / length_now, now), scale(1.0 / (length_before + length_now), add(before, now))


def step(
    x: Array,
    v: Array,
    motion: Array,
    dt: float,
    nodes: Index,
    direction: Array,
    size: Array,
    constants: tuple[float, ...],
    elongation: Array,
    force: Array,
    history: Array,
    push: Array,
    energy: Array,
) -> None:
    """Elongation, force and work 1/2 (f_{n-1} + f_n) dt ddot of each element; the forces go to its nodes.

    `motion` and `push` are v and f of nodes, or omega and moment for torsional elements; `size` is S.
    """
    for i in range(nodes.shape[0]):
        e, m = axes(x, v, dt, nodes[i], direction[i])
        rate = dot(between(motion, nodes[i]), m)
        elongation[i] += dt * rate
        f = size[i] * law(constants, dt, elongation[i], rate, history, i, nodes.shape[0])
        energy[0] += 0.5 * (force[i] + f) * dt * rate
        force[i] = f
        for j in range(3):
            push[nodes[i, 0], j] += f * e[j]
            if nodes[i, 1] >= 0:
                push[nodes[i, 1], j] -= f * e[j]


def load(
    offset: Array,
    size: Array,
    constants: tuple[float, ...],
    elongation: Array,
    force: Array,
    history: Array,
    energy: Array,
) -> None:
    """Stretch unloaded elements to `offset`, so slowly that no damper resists: their energy at the start."""
    for i in range(offset.size):
        increment = offset[i] / PIECES
        for piece in range(1, PIECES + 1):
            f = size[i] * law(constants, 0.0, piece * increment, 0.0, history, i, offset.size)
            energy[0] += 0.5 * (force[i] + f) * increment
            force[i] = f
        elongation[i] = offset[i]
