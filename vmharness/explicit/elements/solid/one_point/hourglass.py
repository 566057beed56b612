"""Hourglass control: resistance to patterns 4 to 7 along three axes, twelve motions without strain at the one point.

With the patterns x_a of the geometry and v_a of the velocity, the rates

    q_a = v_a - L x_a                                             a = 4 to 7

vanish for every linear velocity field: this is 1/8 gamma . v of Flanagan and Belytschko (International Journal for
Numerical Methods in Engineering 17 (1981) 679-706). Types 2 and 3 resist them by viscous forces, 4 and 5 by elastic
ones; here B is always the exact derivative of the volume, so that 3 is the same as 2, and 5 as 4. Type 1 takes q_a =
v_a, which also resists rigid rotation and straining of an element that is no parallelepiped.

Force on a pattern (64 h_a on nodal forces of the size h_a):

    viscous     Q = 16 QM rho c V^(2/3) q                          (at the nodes QM rho c V^(2/3) / 4, as LS-DYNA)
    stiffness   dQ/dt = QM rho c^2 sum |int b_k|^2 / (2 V) q       (Flanagan, Belytschko 1981)

Moduli are those of the initial geometry. The stiffness form keeps Q in the frame that rotates with the element; its
stored energy is sum Q^2 / 2C. On a cube of side L the pattern's frequency is sqrt(6 QM) c/L; at nu = 0.3, QM = 0.165
gives an element the exact stiffness in bending. The viscous force itself limits the step to 2 m q / Q =
V^(1/3) / (8 QM c): it governs where QM is above about 0.125.
"""

from dataclasses import dataclass

import numpy as np

from vmharness.explicit.elements.solid._gradient import measures
from vmharness.explicit.elements.solid._rows import (
    GRADIENT,
    HOURGLASS,
    HOURGLASS_WORK,
    MIDDLE,
    MODULUS,
    NOW,
    RESISTANCE,
    V,
    X,
    load_patterns,
    load_tensor,
)
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import matvec
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import add, combine, components, dot, scale, subtract
from vmharness.explicit.state import Array


@dataclass(frozen=True)
class Hourglass:
    """Control type IHQ (1 to 3 viscous, 4 and 5 stiffness) and its coefficient."""

    ihq: int = 2
    qm: float = 0.1

    def __post_init__(self) -> None:
        if self.ihq not in (1, 2, 3, 4, 5):
            raise ValueError(f"IHQ = {self.ihq}: solids know 1, 2, 3 (viscous) and 4, 5 (stiffness)")

    @property
    def viscous(self) -> bool:
        """Whether forces are proportional to the rates, not to the displacements."""
        return self.ihq <= 3

    @property
    def projected(self) -> bool:
        """Whether linear velocity fields have no hourglass force."""
        return self.ihq != 1


def moduli(x: Array, density: float, modulus: float, control: Hourglass) -> Array:
    """Q/q of the viscous form or dQ/dt/q of the stiffness form (ne,).

    `x (ne, 8, 3)`: corners; `modulus`: rho c^2. Consistent units.
    """
    volume, squares, _ = measures(x)
    if control.viscous:
        return np.asarray(16 * control.qm * (density * modulus) ** 0.5 * np.cbrt(volume) ** 2)
    return np.asarray(control.qm * modulus * squares / (2 * volume))


@kernel
def rates(work: Array, dt: float, projected: bool) -> None:
    """HOURGLASS = q_a at mid-step."""
    project, half = (1.0 if projected else 0.0), -0.5 * dt
    for e in range(LANES):
        x, v, L = load_patterns(work, X, e), load_patterns(work, V, e), load_tensor(work, GRADIENT, e)
        put(work, HOURGLASS, e, subtract(v[3], scale(project, matvec(L, add(x[3], scale(half, v[3]))))))
        put(work, HOURGLASS + 3, e, subtract(v[4], scale(project, matvec(L, add(x[4], scale(half, v[4]))))))
        put(work, HOURGLASS + 6, e, subtract(v[5], scale(project, matvec(L, add(x[5], scale(half, v[5]))))))
        put(work, HOURGLASS + 9, e, subtract(v[6], scale(project, matvec(L, add(x[6], scale(half, v[6]))))))


@kernel
def forces(work: Array, dt: float, fixed: Array, viscous: bool, kept: Array) -> None:
    """HOURGLASS = Q_a: Q += C q dt (stiffness) or Q = c q (viscous), and their work 1/2 (Q_{n-1} + Q_n) . q dt."""
    memory, gain = (0.0, 1.0) if viscous else (1.0, dt)
    for e in range(LANES):
        work[HOURGLASS_WORK * LANES + e] = 0.0
    for a in range(4):
        for e in range(LANES):
            q = components(load_tensor(work, MIDDLE, e), vector(work, HOURGLASS + 3 * a, e))
            past = vector(kept, RESISTANCE + 3 * a, e)
            now = add(scale(memory, past), scale(gain * fixed[MODULUS * LANES + e], q))
            put(kept, RESISTANCE + 3 * a, e, now)
            put(work, HOURGLASS + 3 * a, e, combine(load_tensor(work, NOW, e), now))
            work[HOURGLASS_WORK * LANES + e] += 0.5 * dt * dot(add(past, now), q)
