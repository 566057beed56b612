"""Quantities of probes: a component is named by its axis and its quantity, as `z-displacement`."""

from collections.abc import Callable, Mapping

from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array

Probe = Callable[[], float]

AXES = {"x": 0, "y": 1, "z": 2}


class ProbeError(ValueError):
    """The model does not have the quantity of a channel."""


def split(component: str) -> tuple[int, str]:
    """Axis and quantity of a component.

    >>> split("z-angular-velocity")
    (2, 'angular-velocity')
    """
    axis, _, quantity = component.partition("-")
    if axis not in AXES or not quantity:
        raise ProbeError(f"component {component!r} is not of the form z-displacement")
    return AXES[axis], quantity


def choose(probes: Mapping[str, Probe], name: str, of: str) -> Probe:
    """The probe named `name`; raises ProbeError with the names there are `of` something."""
    try:
        return probes[name]
    except KeyError:
        raise ProbeError(f"no {name!r} {of}; there are: {', '.join(probes)}") from None


def of_point(model: Model, row: int, axis: int) -> dict[str, Probe]:
    """By name, the motion at t_n along an axis of the point in a row of the state."""
    s, place = model.state, (row, axis)
    x0 = float(model.x0[place])
    return {
        "displacement": lambda: s.x[place] - x0,
        "coordinate": lambda: s.x[place],
        "velocity": lambda: s.v[place] + 0.5 * s.dt * s.a[place],  # v_{n-1/2} -> v_n
        "acceleration": lambda: s.a[place],
    }


def of_resultant(total: Array, component: str, of: str) -> Probe:
    """The probe of a component of a force and a moment, `total` (6,)."""
    axis, quantity = split(component)
    return choose({"force": lambda: total[axis], "moment": lambda: total[3 + axis]}, quantity, of)
