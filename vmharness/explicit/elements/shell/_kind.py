"""What a kind of shell has of its own."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from vmharness.explicit.elements.shell import _point as point
from vmharness.explicit.elements.shell import _step as step
from vmharness.explicit.kernels.compiled import specialise
from vmharness.explicit.materials._plasticity.long_curves import with_law
from vmharness.explicit.model.state import Array


@dataclass(frozen=True)
class Kind:
    """Geometry, mass and the stages of a step, for elements of `corners (ne, n, 3)`.

    `area(corners)` (ne,); `nodal_mass(corners, thickness, density, nu, shrf)`, mass and inertia (ne,) of each node;
    `at`: the corners of element e in the buffer; `lengths`: the characteristic lengths of such corners, by ISDO;
    `strain`, `hourglass_force`, `force`: see shell/step.py.
    """

    area: Callable[[Array], Array]
    nodal_mass: Callable[[Array, Array, float, float, float], tuple[Array, Array]]
    at: Callable[..., Any]
    lengths: tuple[Callable[..., float], ...]
    strain: Callable[..., None]
    hourglass_force: Callable[..., None]
    force: Callable[..., None]


@cache
def compiled_step(kind: Kind, law: Callable[..., Any], long_curve: bool, isdo: int) -> Callable[..., float]:
    """The step for one law (`long_curve`: see materials/_plasticity/long_curves.py) and one characteristic length."""
    return specialise(
        step.step,
        strain=kind.strain,
        stress_at_point=with_law(point.stress_at_point, law, long_curve),
        hourglass_force=kind.hourglass_force,
        force=specialise(kind.force, length=kind.lengths[isdo]),
    )


@cache
def compiled_lengths(kind: Kind, isdo: int) -> Callable[..., None]:
    """The characteristic lengths of many elements."""
    return specialise(step.lengths, corners=kind.at, length=kind.lengths[isdo])
