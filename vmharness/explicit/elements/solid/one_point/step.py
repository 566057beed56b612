"""One step of many solids with one point: motion, strain, stress, hourglass forces, forces at the end of the step.

Arrays per block of LANES elements, with rows as in solid/_rows.py: `nodes (blocks, 8 rows)`; `fixed (blocks, 3
rows)`, mass, hourglass modulus, wave speed; `kept (blocks, 17 rows)`, frame, bulk viscosity, hourglass forces; `stress
(blocks, 1, 6 rows)`; `history (blocks, 1, rows)`. The last block is filled with copies of the last element, which add
neither force nor energy.
"""

from typing import Any

import numpy as np

from vmharness.explicit.elements.solid._gradient import mean
from vmharness.explicit.elements.solid._motion import mean_strain, motion
from vmharness.explicit.elements.solid._pattern import nodal
from vmharness.explicit.elements.solid._rows import (
    HOURGLASS,
    HOURGLASS_WORK,
    NOW,
    PRESSURE,
    STEP,
    WORK,
    F,
    V,
    X,
    load_patterns,
    load_tensor,
    store_nodes,
)
from vmharness.explicit.elements.solid._viscosity import stable_step, viscosity
from vmharness.explicit.elements.solid.one_point.hourglass import forces, rates
from vmharness.explicit.kernels.compiled import kernel, to_be_bound
from vmharness.explicit.kernels.rotation import matvec, stress_in_space
from vmharness.explicit.kernels.simd import LANES, gather, scatter, vector
from vmharness.explicit.kernels.vector import Vector, add, inlined, scale, subtract
from vmharness.explicit.state import Array, Index

stress_at_point = to_be_bound("stress_at_point")


@kernel
def force(work: Array, stress: Array, projected: bool) -> None:
    """Nodal forces on the geometry at the end of the step.

    The power V (s - q I) : L + sum Q_a . q_a with the hourglass rates q_a = v_a - L x_a (a = 4 to 7) gives pattern k

        f_k = T int b_k + Q_k,   T = s - q I - 1/V sum Q_a (x) x_a

    (T without its last term where the hourglass rates are not `projected`.)
    """
    project = 1.0 if projected else 0.0
    for e in range(LANES):
        x = load_patterns(work, X, e)
        volume, b = mean(x)
        q = work[PRESSURE * LANES + e]
        normal, shear = vector(stress, 0, e), vector(stress, 3, e)
        s = stress_in_space(load_tensor(work, NOW, e), subtract(normal, (q, q, q)), shear)
        Q4, Q5 = vector(work, HOURGLASS, e), vector(work, HOURGLASS + 3, e)
        Q6, Q7 = vector(work, HOURGLASS + 6, e), vector(work, HOURGLASS + 9, e)
        share = -project / volume
        T = (
            add(s[0], scale(share, _by_x(Q4[0], Q5[0], Q6[0], Q7[0], x[3], x[4], x[5], x[6]))),
            add(s[1], scale(share, _by_x(Q4[1], Q5[1], Q6[1], Q7[1], x[3], x[4], x[5], x[6]))),
            add(s[2], scale(share, _by_x(Q4[2], Q5[2], Q6[2], Q7[2], x[3], x[4], x[5], x[6]))),
        )
        f = (
            matvec(T, b[0]),
            matvec(T, b[1]),
            matvec(T, b[2]),
            add(matvec(T, b[3]), Q4),
            add(matvec(T, b[4]), Q5),
            add(matvec(T, b[5]), Q6),
            Q7,
        )
        store_nodes(work, F, e, nodal(f))


@inlined
def _by_x(
    q4: float, q5: float, q6: float, q7: float, x4: Vector, x5: Vector, x6: Vector, x7: Vector
) -> Vector:
    """q_4 x_4 + ... + q_7 x_7."""
    return add(add(scale(q4, x4), scale(q5, x5)), add(scale(q6, x6), scale(q7, x7)))


def step(
    # state
    x: Array,
    v: Array,
    dt: float,
    # elements
    nodes: Index,
    elements: int,
    fixed: Array,
    # formulation and material
    modulus: float,
    viscous: tuple[float, float],
    hourglass: tuple[bool, bool],
    constants: Any,
    # elements, in and out
    kept: Array,
    stress: Array,
    history: Array,
    # out
    f: Array,
    energy: Array,
    # buffer
    work: Array,
) -> float:
    """Bring stresses to t_n, add forces and the work of the step; return the shortest stable step.

    `x`, `v`, `f` (n, 3); `modulus`: rho c^2; `viscous`: Q1, Q2; `hourglass`: viscous form?, projected?; `energy` (2,):
    internal, hourglass.
    """
    q1, q2 = viscous
    for e in range(LANES):
        work[STEP * LANES + e] = np.inf
    for block in range(len(nodes)):
        gather(x, nodes[block], work, X)
        gather(v, nodes[block], work, V)
        motion(work, dt, kept[block])
        mean_strain(work, dt)
        stress_at_point(work, dt, constants, stress[block, 0], history[block, 0])
        viscosity(work, dt, fixed[block], modulus, q1, q2, kept[block])
        stable_step(work, fixed[block], q1, q2)
        rates(work, dt, hourglass[1])
        forces(work, dt, fixed[block], hourglass[0], kept[block])
        force(work, stress[block, 0], hourglass[1])
        count = min(LANES, elements - block * LANES)
        scatter(f, nodes[block], count, work, F)
        for e in range(count):
            energy[0] += work[WORK * LANES + e]
            energy[1] += work[HOURGLASS_WORK * LANES + e]
    shortest = np.inf
    for e in range(LANES):
        shortest = min(shortest, work[STEP * LANES + e])
    return shortest
