"""Bulk viscosity, and the stable step with it.

A pressure that spreads shocks over a few elements, in compression only (J. von Neumann, R. D. Richtmyer 1950, with
Landshoff's linear term; LS-DYNA: *CONTROL_BULK_VISCOSITY TYPE 1):

    q = rho l (Q1 l D^2 - Q2 c D)  for D = tr(velocity gradient) < 0, else 0;   l = V^(1/3),  rho = m/V

It acts with the stress, but is no part of the stress that probes show; its work is internal energy. The stable step of
the element is

    dt = L_e / (Q + sqrt(Q^2 + c^2)),   L_e = V / largest face
    Q = Q2 c + Q1 L_e |D|  for D < 0, else 0

as in LS-DYNA, with the wave speed c of the initial density, c^2 = E (1 - nu) / ((1 + nu) (1 - 2 nu) rho_0): at 25 %
uniaxial compression the step is 0.75 of that at the start. It is the classical estimate, not a bound: a single free
cube is stable up to sqrt((1 - nu) / (1 + nu)) L_e/c only (0.73 at nu = 0.3), the limit of the mode that stretches it in
all directions; a long bar of cubes, one across, up to 0.81 L_e/c. timestep/stable_step.py sees to such meshes.
"""

import numpy as np

from vmharness.explicit.elements.solid._gradient import largest_face, mean
from vmharness.explicit.elements.solid._rows import (
    GRADIENT,
    MASS,
    PRESSURE,
    SPEED,
    STEP,
    VISCOSITY,
    VOLUME,
    WORK,
    X,
    load_patterns,
)
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.simd import LANES
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.state import Array


@inlined
def dilatation(work: Array, e: int) -> float:
    """D = tr L, the mean rate of the volumetric strain."""
    return work[GRADIENT * LANES + e] + work[(GRADIENT + 4) * LANES + e] + work[(GRADIENT + 8) * LANES + e]


@kernel
def viscosity(
    work: Array, dt: float, fixed: Array, modulus: float, q1: float, q2: float, kept: Array
) -> None:
    """PRESSURE = q at the end of the step, and its work -V 1/2 (q_{n-1} + q_n) D dt; `modulus` is rho c^2."""
    for e in range(LANES):
        D, q = dilatation(work, e), 0.0
        if D < 0.0:
            volume = work[VOLUME * LANES + e]
            rho, length = fixed[MASS * LANES + e] / volume, np.cbrt(volume)
            q = length * (q1 * rho * length * D * D - q2 * (modulus * rho) ** 0.5 * D)
        past = kept[VISCOSITY * LANES + e]
        kept[VISCOSITY * LANES + e] = q
        work[PRESSURE * LANES + e] = q
        work[WORK * LANES + e] -= 0.5 * work[VOLUME * LANES + e] * (past + q) * D * dt


@kernel
def stable_step(work: Array, fixed: Array, q1: float, q2: float) -> None:
    """STEP = the shortest dt of the elements of this lane so far."""
    for e in range(LANES):
        x = load_patterns(work, X, e)
        volume, _ = mean(x)
        length = volume / largest_face(x)
        D, c = dilatation(work, e), fixed[SPEED * LANES + e]
        Q = q2 * c - q1 * length * D if D < 0.0 else 0.0
        work[STEP * LANES + e] = min(work[STEP * LANES + e], length / (Q + (Q * Q + c * c) ** 0.5))
