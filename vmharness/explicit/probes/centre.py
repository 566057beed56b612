"""Motion of the centre of mass of a part, or of the model."""

from typing import Literal

import numpy as np

from vmharness.explicit.force import Scalable
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.explicit.probe import Probe, ProbeError, choose, split

KEYS = ("centre",)


def probe(model: Model, centre: int | Literal["all"], component: str) -> Probe:
    """A component of the motion of the centre of mass, of all or of a part: `x-velocity`, `x-momentum`.

    A part has the mass of its elements alone.
    """
    mass = model.state.mass if centre == "all" else _mass_of(model, centre)
    total = float(mass.sum())
    if total == 0.0:
        raise ProbeError(
            "no mass in the deck" if centre == "all" else f"no elements with mass in part {centre}"
        )
    axis, quantity = split(component)
    s, share, x0 = model.state, mass / total, model.x0[:, axis]

    def velocity() -> float:
        return float(share @ (s.v[:, axis] + 0.5 * s.dt * s.a[:, axis]))

    probes: dict[str, Probe] = {
        "displacement": lambda: float(share @ (s.x[:, axis] - x0)),
        "velocity": velocity,
        "momentum": lambda: total * velocity(),
    }
    return choose(probes, quantity, "of a centre of mass")


def _mass_of(model: Model, part: int) -> Array:
    """What each node (n,) has of the mass of a part."""
    mass = np.zeros(model.ids.size)
    for force in model.forces:
        if isinstance(force, Scalable) and force.pid == part:
            np.add.at(mass, force.nodes, force.mass[:, None])
    return mass
