"""What can be read off a rigid body: its centre, its rotation, and what holds or drives it."""

from collections.abc import Callable

import numpy as np

from vmharness.explicit.rigid.bodies import Bodies

Quantity = Callable[[], float]


def quantities(bodies: Bodies, number: int, axis: int) -> dict[str, Quantity]:
    """By name, the quantities of the body `number` along or about a global axis, at t_n.

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
