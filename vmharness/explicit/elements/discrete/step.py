"""One step of the discrete elements of a part; arrays are of its elements (ne), vectors of nodes are (n, 3)."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.kernels.compiled import kernel, to_be_bound
from vmharness.explicit.kernels.vector import Vector, add, dot, inlined, scale, subtract
from vmharness.explicit.materials import Spring
from vmharness.explicit.state import Array, Index

law: Spring = to_be_bound("law")

PIECES = 1000  # of the way from the unloaded state to OFFSET


@inlined
def nodal_vector(field: Array, node: int) -> Vector:
    """The vector of a node; zero for the ground, -1."""
    if node < 0:
        return 0.0, 0.0, 0.0
    return field[node, 0], field[node, 1], field[node, 2]


@inlined
def relative(field: Array, ends: Index) -> Vector:
    """The vector of node 2 minus that of node 1."""
    return subtract(nodal_vector(field, ends[1]), nodal_vector(field, ends[0]))


@inlined
def axes(x: Array, v: Array, dt: float, ends: Index, direction: Array, guide: Index) -> tuple[Vector, Vector]:
    """The axis e_n, and the m along which rates are measured."""
    fixed = (direction[0], direction[1], direction[2])
    if dot(fixed, fixed) > 0.0 and guide[2] == 0:
        return fixed, fixed
    now, w = relative(x, ends), fixed
    before = subtract(now, scale(dt, relative(v, ends)))
    w_before = w
    if guide[0] >= 0:
        w = relative(x, guide)
        w_before = subtract(w, scale(dt, relative(v, guide)))
    if guide[2] == 1:
        now, before = project(now, w), project(before, w_before)
    elif guide[0] >= 0:
        now, before = w, w_before
    length_now, length_before = np.sqrt(dot(now, now)), np.sqrt(dot(before, before))
    return scale(1.0 / length_now, now), scale(1.0 / (length_before + length_now), add(before, now))


@inlined
def project(r: Vector, w: Vector) -> Vector:
    """r - (r . w) w / (w . w)."""
    return subtract(r, scale(dot(r, w) / dot(w, w), w))


@inlined
def effective_elongation(elongation: float, clearance: float) -> float:
    """The elongation that the law gets: min(d + CL, 0) with a clearance, else d."""
    return min(elongation + clearance, 0.0) if clearance > 0.0 else elongation


def step(
    # state
    x: Array,
    v: Array,
    motion: Array,
    dt: float,
    # elements
    nodes: Index,
    direction: Array,
    guide: Index,
    scale_factor: Array,
    # material
    constants: Any,
    limits: tuple[float, float],
    # elements, in and out
    broken: NDArray[np.bool_],
    elongation: Array,
    force: Array,
    history: Array,
    # out
    loads: Array,
    energy: Array,
) -> None:
    """Elongation, force and work 1/2 (f_{n-1} + f_n) dt ddot of each element; the forces go to its nodes.

    `motion` and `loads` are v and f of nodes, or omega and moment for torsional elements; `scale_factor` is S; `limits`
    are CL and FD; `direction` and `guide`: see part.py.
    """
    clearance, failure = limits
    for i in range(nodes.shape[0]):
        e, m = axes(x, v, dt, nodes[i], direction[i], guide[i])
        rate = dot(relative(motion, nodes[i]), m)
        elongation[i] += dt * rate
        d = effective_elongation(elongation[i], clearance)
        f = scale_factor[i] * law(constants, dt, d, rate, history, i, nodes.shape[0])
        if failure * elongation[i] > failure * failure:
            broken[i] = True
        if broken[i]:
            f = 0.0
        energy[0] += 0.5 * (force[i] + f) * dt * rate
        force[i] = f
        for j in range(3):
            loads[nodes[i, 0], j] += f * e[j]
            if nodes[i, 1] >= 0:
                loads[nodes[i, 1], j] -= f * e[j]


@kernel
def linear_step(
    x: Array,
    v: Array,
    motion: Array,
    dt: float,
    nodes: Index,
    direction: Array,
    guide: Index,
    stiffness: Array,
    damping: Array,
    loads: Array,
) -> None:
    """Add the forces (k dt + 2 c) ddot of linear springs and dampers (ne,): see `Elements.linearised`."""
    for i in range(nodes.shape[0]):
        e, m = axes(x, v, dt, nodes[i], direction[i], guide[i])
        f = (stiffness[i] * dt + 2.0 * damping[i]) * dot(relative(motion, nodes[i]), m)
        for j in range(3):
            loads[nodes[i, 0], j] += f * e[j]
            if nodes[i, 1] >= 0:
                loads[nodes[i, 1], j] -= f * e[j]


def preload(
    offset: Array,
    scale_factor: Array,
    constants: Any,
    clearance: float,
    elongation: Array,
    force: Array,
    history: Array,
    energy: Array,
) -> None:
    """Stretch unloaded elements to `offset`, so slowly that no damper resists: their energy at the start."""
    for i in range(offset.size):
        increment = offset[i] / PIECES
        for piece in range(1, PIECES + 1):
            d = effective_elongation(piece * increment, clearance)
            f = scale_factor[i] * law(constants, 0.0, d, 0.0, history, i, offset.size)
            energy[0] += 0.5 * (force[i] + f) * increment
            force[i] = f
        elongation[i] = offset[i]
