"""Interface of a shell formulation: geometry, mass, strain, hourglass control, nodal force."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from vmharness.explicit.elements.shell import _point as point
from vmharness.explicit.elements.shell import _step as step
from vmharness.explicit.kernels.compiled import specialise
from vmharness.explicit.materials import with_law
from vmharness.explicit.state import Array


@dataclass(frozen=True)
class Formulation:
    """Mass and kernels of shells with the same number of corners.

    `nodal_mass(corners, thickness, density, nu, shrf)`: mass and rotary inertia (ne,) of each node; `load_corners(work,
    row, e)`: the vectors of element e in the buffer; `lengths`: characteristic length of such corners, by ISDO;
    `strain`, `hourglass_force`, `force`: the stages of _step.py.
    """

    nodal_mass: Callable[[Array, Array, float, float, float], tuple[Array, Array]]
    load_corners: Callable[..., Any]
    lengths: tuple[Callable[..., float], ...]
    strain: Callable[..., None]
    hourglass_force: Callable[..., None]
    force: Callable[..., None]


@cache
def compiled_step(
    formulation: Formulation, law: Callable[..., Any], long_curve: bool, isdo: int
) -> Callable[..., float]:
    """The step for one law and one characteristic length; `long_curve`: see `with_law`."""
    return specialise(
        step.step,
        strain=formulation.strain,
        stress_at_point=with_law(point.stress_at_point, law, long_curve),
        hourglass_force=formulation.hourglass_force,
        force=specialise(formulation.force, length=formulation.lengths[isdo]),
    )


@cache
def compiled_lengths(formulation: Formulation, isdo: int) -> Callable[..., None]:
    """The characteristic lengths of many elements."""
    return specialise(step.lengths, load_corners=formulation.load_corners, length=formulation.lengths[isdo])
