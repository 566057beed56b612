"""The state of a run: what moves, and what pushes."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]  # rows of arrays
Flags = NDArray[np.bool_]


@dataclass(slots=True)
class State:
    """Nodal arrays at time t_n, in consistent units; one object, updated in place by the time loop.

    While forces are added, `v` and `omega` are v_{n-1/2} and omega_{n-1/2}, and `dt` = t_n - t_{n-1} is the step
    that led here (0 at the start, where `v` is v_0). `x`, `a`, `f` and their rotational partners are at t_n.
    """

    x: Array  # (n, 3) current coordinates
    v: Array  # (n, 3) velocity
    omega: Array  # (n, 3) angular velocity
    mass: Array  # (n,) lumped mass; that of a rigid body is at its centre
    inertia: Array  # (n,) lumped rotary inertia, the same about every axis
    t: float = 0.0
    dt: float = 0.0
    cycle: int = 0
    a: Array = field(init=False)  # (n, 3) acceleration
    alpha: Array = field(init=False)  # (n, 3) angular acceleration
    f: Array = field(init=False)  # (n, 3) force
    moment: Array = field(init=False)  # (n, 3) moment
    lumped: Array = field(init=False)  # (n,) as `mass`, but nodes of rigid bodies have shares: for contacts

    def __post_init__(self) -> None:
        for name in ("a", "alpha", "f", "moment"):
            setattr(self, name, np.zeros_like(self.x))
        self.lumped = self.mass
