"""One step of many shells: gather, rates at mid-step, stresses, forces at the end of the step, scatter.

Arrays per block of LANES elements, with rows as in _rows.py: `nodes (blocks, corners rows)`; `section (blocks, rows)`,
thickness, square root of the factor of density (1 without mass scaling), hourglass moduli; `stress (blocks, nip, 5
rows)`, xx, yy, xy, yz, zx; `history (blocks, nip, rows)`; `hourglass (blocks, rows)` of the formulation. The last block
is filled with copies of the last element, which add neither force nor energy.
"""

from typing import Any

import numpy as np

from vmharness.explicit.elements.shell._rows import HOURGLASS_WORK, LENGTH, MOMENT, OMEGA, WORK, F, V, X
from vmharness.explicit.elements.shell._thickness import update_thickness
from vmharness.explicit.kernels.compiled import to_be_bound
from vmharness.explicit.kernels.simd import LANES, gather, scatter
from vmharness.explicit.state import Array, Index

# The stages of a formulation, and the material's law at a point: see _formulation.py.
strain = to_be_bound("strain")
stress_at_point = to_be_bound("stress_at_point")
hourglass_force = to_be_bound("hourglass_force")
force = to_be_bound("force")
load_corners = to_be_bound("load_corners")
length = to_be_bound("length")


def step(
    # state
    x: Array,
    v: Array,
    omega: Array,
    dt: float,
    # elements
    nodes: Index,
    elements: int,
    section: Array,
    # formulation and material
    points: Array,
    shrf: float,
    thinning: bool,
    viscous: bool,
    constants: Any,
    # elements, in and out
    stress: Array,
    history: Array,
    hourglass: Array,
    # out
    f: Array,
    moment: Array,
    energy: Array,
    # buffer
    work: Array,
) -> float:
    """Bring stresses to t_n, add forces, moments and the work of the step; return the shortest L_s.

    `x`, `v`, `omega`, `f`, `moment` (n, 3); `points` (nip, 2): height -1..1 and weight of sum 2; `energy` (2,):
    internal, hourglass.
    """
    for e in range(LANES):
        work[LENGTH * LANES + e] = np.inf
    for block in range(len(nodes)):
        gather(x, nodes[block], work, X)
        gather(v, nodes[block], work, V)
        gather(omega, nodes[block], work, OMEGA)
        strain(work, dt)
        for p in range(len(points)):
            zeta, weight = points[p]
            stress_at_point(
                work, dt, section[block], zeta, weight, shrf, constants, stress[block, p], history[block, p]
            )
        if thinning:
            update_thickness(work, section[block])
        hourglass_force(work, dt, section[block], viscous, hourglass[block])
        force(work, section[block])
        count = min(LANES, elements - block * LANES)
        scatter(f, nodes[block], count, work, F)
        scatter(moment, nodes[block], count, work, MOMENT)
        for e in range(count):
            energy[0] += work[WORK * LANES + e]
            energy[1] += work[HOURGLASS_WORK * LANES + e]
    shortest = np.inf
    for e in range(LANES):
        shortest = min(shortest, work[LENGTH * LANES + e])
    return shortest


def lengths(x: Array, nodes: Index, work: Array, out: Array) -> None:
    """L_s (ne,) of each element; `x (n, 3)`, `nodes (blocks, corners rows)`."""
    for block in range(len(nodes)):
        gather(x, nodes[block], work, X)
        for e in range(min(LANES, len(out) - block * LANES)):
            out[block * LANES + e] = length(load_corners(work, X, e))
