"""A material's law at one point of every element of a block, in the element's frame."""

from collections.abc import Callable
from functools import cache
from typing import Any

from vmharness.explicit.elements.solid._rows import STRAIN, VOLUME, WORK
from vmharness.explicit.kernels.compiled import specialise, to_be_bound
from vmharness.explicit.kernels.simd import LANES, put, vector
from vmharness.explicit.kernels.vector import add, dot
from vmharness.explicit.materials import Solid, with_law
from vmharness.explicit.state import Array

law: Solid = to_be_bound("law")


def stress_at_point(work: Array, dt: float, constants: Any, stress: Array, history: Array) -> None:
    """Update `stress` (6 rows: 11, 22, 33, 12, 23, 31) by STRAIN; work += V 1/2 (s_{n-1} + s_n) . de."""
    for e in range(LANES):
        dn, ds = vector(work, STRAIN, e), vector(work, STRAIN + 3, e)
        pn, ps = vector(stress, 0, e), vector(stress, 3, e)
        sxx, syy, szz, sxy, syz, szx = law(
            constants,
            dt,
            dn[0],
            dn[1],
            dn[2],
            ds[0],
            ds[1],
            ds[2],
            pn[0],
            pn[1],
            pn[2],
            ps[0],
            ps[1],
            ps[2],
            history,
            e,
            LANES,
        )
        normal, shear = (sxx, syy, szz), (sxy, syz, szx)
        put(stress, 0, e, normal)
        put(stress, 3, e, shear)
        work[WORK * LANES + e] += (
            0.5 * work[VOLUME * LANES + e] * (dot(add(pn, normal), dn) + dot(add(ps, shear), ds))
        )


@cache
def compiled_step(
    step: Callable[..., float], law: Callable[..., Any], long_curve: bool
) -> Callable[..., float]:
    """The `step` of a formulation for one law; `long_curve`: see `with_law`."""
    return specialise(step, stress_at_point=with_law(stress_at_point, law, long_curve))
