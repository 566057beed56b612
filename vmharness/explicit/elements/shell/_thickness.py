"""Change of thickness by the mean strain through it (LS-DYNA: ISTUPD = 1); without it the thickness is constant.

    t_n = t_{n-1} (1 + de_zz/2) / (1 - de_zz/2)        the midpoint rule, exp(de_zz) to the third order

Resultants are first computed with the thickness at the start of the step. At its end forces are larger by the ratio of
thicknesses, and moments by its square, since the distances of the points change too. The work of the step is that of
the mean. Mass and hourglass moduli are constant.
"""

from vmharness.explicit.elements.shell._rows import THINNING, WORK, M, N, S
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import scale
from vmharness.explicit.state import Array


@kernel
def update_thickness(work: Array, section: Array) -> None:
    """Bring thickness, resultants and work of LANES elements to the end of the step."""
    for e in range(LANES):
        half = 0.5 * work[THINNING * LANES + e]
        ratio = (1 + half) / (1 - half)
        section[e] *= ratio
        put(work, N, e, scale(ratio, vector(work, N, e)))
        put(work, S, e, scale(ratio, vector(work, S, e)))
        put(work, M, e, scale(ratio * ratio, vector(work, M, e)))
        work[WORK * LANES + e] *= 0.5 * (1 + ratio)
