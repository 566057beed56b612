"""Motion of a rigid body, and what holds or drives it."""

import numpy as np

from vmharness.explicit.model.model import Model
from vmharness.explicit.probe import Probe, ProbeError, choose, of_point, split
from vmharness.explicit.rigid.bodies import Bodies

KEYS = ("rigid",)


def probe(model: Model, rigid: int, component: str) -> Probe:
    """Of a rigid body: motion of its centre as of a node, `z-angular-velocity`, `z-rotation`, ... of the body."""
    axis, quantity = split(component)
    for bodies in model.constraints:
        if isinstance(bodies, Bodies) and rigid in bodies.numbers:
            motion = of_point(model, model.centre(rigid), axis)
            return choose(motion | _turning(bodies, rigid, axis), quantity, "of a rigid body")
    raise ProbeError(f"no rigid body {rigid} in the deck")


def _turning(bodies: Bodies, number: int, axis: int) -> dict[str, Probe]:
    """By name, the quantities of a body about a global axis at t_n, and what rules it along that axis.

    `rotation` is the integral of the angular velocity: the angle, where the axis of rotation keeps its direction.
    `force` and `moment` are those by which CMO and driven rotations rule the body; the moment is about the centre.
    """
    b = int(np.flatnonzero(bodies.numbers == number)[0])
    return {
        "angular-velocity": lambda: bodies.spin[b, axis],
        "rotation": lambda: bodies.turned[b, axis],
        "angular-momentum": lambda: float(bodies.momentum(b)[axis]),
        "force": lambda: bodies.reaction[b, axis],
        "moment": lambda: bodies.reaction[b, 3 + axis],
    }
