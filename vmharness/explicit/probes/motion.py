"""Motion of a node, of a rigid body, and of the centre of mass of a part or of the model."""

from typing import Literal

import numpy as np

from vmharness.explicit.force import Scalable
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes._quantity import Probe, ProbeError, choose, of_point, split
from vmharness.explicit.rigid.constraints import RigidBodies
from vmharness.explicit.state import Array


def of_node(model: Model, node: int, component: str) -> Probe:
    """A component of the motion of a node at t_n: `z-displacement`, `x-velocity`, `y-acceleration`, `z-coordinate`."""
    rows = np.flatnonzero((model.ids == node) & (model.ids > 0))
    if not rows.size:
        raise ProbeError(f"no node {node} in the deck")
    axis, quantity = split(component)
    return choose(of_point(model, int(rows[0]), axis), quantity, "of a node")


def of_body(model: Model, rigid: int, component: str) -> Probe:
    """A component of the motion of a rigid body: of its centre as of a node, `z-angular-velocity`, `z-rotation`, ..."""
    axis, quantity = split(component)
    for item in model.constraints:
        if isinstance(item, RigidBodies) and rigid in item.bodies.numbers:
            motion = of_point(model, model.centre(rigid), axis)
            return choose(motion | _rotation(item, rigid, axis), quantity, "of a rigid body")
    raise ProbeError(f"no rigid body {rigid} in the deck")


def _rotation(item: RigidBodies, number: int, axis: int) -> dict[str, Probe]:
    """By name, the rotation of a body about a global axis at t_n, and the reactions along and about that axis.

    `rotation` is the integral of the angular velocity: the angle, if the axis of rotation keeps its direction.
    `force` and `moment` are those of CMO and of driven rotations on the body; the moment is about its centre.
    """
    bodies, reaction = item.bodies, item.reaction
    b = int(np.flatnonzero(bodies.numbers == number)[0])
    return {
        "angular-velocity": lambda: bodies.spin[b, axis],
        "rotation": lambda: bodies.angle[b, axis],
        "angular-momentum": lambda: float(bodies.angular_momentum(b)[axis]),
        "force": lambda: reaction[b, axis],
        "moment": lambda: reaction[b, 3 + axis],
    }


def of_centre(model: Model, centre: int | Literal["all"], component: str) -> Probe:
    """A component of the motion of the centre of mass, of the model or of a part: `x-velocity`, `x-momentum`.

    The mass of a part is that of its elements alone.
    """
    mass = model.state.mass if centre == "all" else _mass_of_part(model, centre)
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


def _mass_of_part(model: Model, part: int) -> Array:
    """The mass (n,) that the elements of a part give to each node."""
    mass = np.zeros(model.ids.size)
    for force in model.forces:
        if isinstance(force, Scalable) and force.pid == part:
            np.add.at(mass, force.nodes, force.mass[:, None])
    return mass


PROBES = {"node": of_node, "rigid": of_body, "centre": of_centre}
