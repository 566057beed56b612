"""Stress at one height of many shells, and its contribution to the resultants."""

from typing import Any

from vmharness.explicit.elements.shell._rows import AREA, CURVATURE, MEMBRANE, SHEAR, THINNING, WORK, M, N, S
from vmharness.explicit.kernels.compiled import to_be_bound
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import add, scale
from vmharness.explicit.materials import PlaneStress
from vmharness.explicit.state import Array

law: PlaneStress = to_be_bound("law")


def stress_at_point(
    work: Array,
    dt: float,
    section: Array,
    zeta: float,
    weight: float,
    shrf: float,
    constants: Any,
    stress: Array,
    history: Array,
) -> None:
    """Update the stress at height z = zeta t/2 and add its contribution to resultants and work, with dz = weight t/2.

    N = int s dz,   M = int z s dz,   S = kappa int s dz,   work = A int 1/2 (s_{n-1} + s_n) de dz
    and to the mean strain through the thickness, int de_zz dz / t.
    """
    for e in range(LANES):
        thickness = section[e]
        z, dz = 0.5 * thickness * zeta, 0.5 * thickness * weight
        membrane, curvature, shear = (
            vector(work, MEMBRANE, e),
            vector(work, CURVATURE, e),
            vector(work, SHEAR, e),
        )
        dexx, deyy, dexy = add(membrane, scale(z, curvature))
        deyz, dezx, _ = shear
        pxx, pyy, pxy = vector(stress, 0, e)
        pyz, pzx = stress[3 * LANES + e], stress[4 * LANES + e]

        sxx, syy, sxy, syz, szx, dezz = law(
            constants, dt, dexx, deyy, dexy, deyz, dezx, pxx, pyy, pxy, pyz, pzx, history, e, LANES
        )

        put(stress, 0, e, (sxx, syy, sxy))
        stress[3 * LANES + e], stress[4 * LANES + e] = syz, szx
        put(work, N, e, add(vector(work, N, e), scale(dz, (sxx, syy, sxy))))
        put(work, M, e, add(vector(work, M, e), scale(z * dz, (sxx, syy, sxy))))
        put(work, S, e, add(vector(work, S, e), scale(shrf * dz, (syz, szx, 0.0))))
        in_plane = (pxx + sxx) * dexx + (pyy + syy) * deyy + (pxy + sxy) * dexy
        across = (pyz + syz) * deyz + (pzx + szx) * dezx
        work[THINNING * LANES + e] += 0.5 * weight * dezz
        work[WORK * LANES + e] += 0.5 * dz * work[AREA * LANES + e] * (in_plane + shrf * across)
