"""All rigid bodies of a model, as two constraints of the time loop.

`Gather` comes before all others: they find the centres accelerated by what pushes on the nodes. `Bodies` comes after
all others: what they have done to the centres is carried to the nodes.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.error import SolverError
from vmharness.explicit.kernels.rotation import rotation_matrix
from vmharness.explicit.model.state import Array, State
from vmharness.explicit.rigid.joint import Joints
from vmharness.explicit.rigid.step import carry, gather, respond, rotate, spread

Index = NDArray[np.intp]
Flags = NDArray[np.bool_]

LARGEST_ANGLE = 1.0  # of a step


class Drive(NamedTuple):
    """A prescribed motion of one rotation of a body, by its place among the bodies."""

    body: int
    axis: int
    total: Array  # (6,) force and moment of the motion, for those who ask it


@dataclass
class Bodies:
    """Rigid bodies (nb,) by their arrays: see step.py; consistent units."""

    numbers: NDArray[np.int64]  # (nb,) of the deck
    centre: Index  # (nb,) rows of the state's arrays
    first: Index  # (nb + 1,)
    nodes: Index  # (m,)
    arm: Array  # (m, 3)
    q: Array  # (nb, 4)
    principal: Array  # (nb, 3)
    inverse: Array  # (nb, 3)
    L: Array  # (nb, 3) angular momentum, L_{n-1/2} while forces are added
    held: Flags  # (nb, 6) degrees of freedom of the centre that CMO holds
    fixed: Flags  # (n, 6) all that the bodies rule
    drives: Sequence[Drive] = ()
    damping: Array | None = None  # (n, 6) the rates D S of mass damping
    joints: Joints | None = None
    name: str = "rigid bodies"
    energy: dict[str, Array] = field(init=False)

    def __post_init__(self) -> None:
        count = self.centre.size
        self.given = self.held[:, 3:].copy()
        for body, axis, _ in self.drives:
            self.given[body, axis] = True
        self.torque, self.spin, self.turned = (
            np.zeros((count, 3)) for _ in range(3)
        )  # T_n, omega_n, int omega dt
        self.reaction = np.zeros((count, 6))  # of CMO and of driven rotations on the body
        self._moment, self._damped = np.zeros((count, 3)), np.zeros((count, 3))
        self.kinetic = np.zeros(1)  # of rotation
        self.energy = {"external work": np.zeros(1), "damping": np.zeros(1)}
        self._still = np.nonzero(self.held[:, :3])

    def accelerate(self, state: State) -> None:
        """The response at t_n: omega_n, alpha_n, joints, reactions, and the acceleration of the nodes."""
        s, (body, axis) = state, self._still
        row = self.centre[body]
        s.a[row, axis] = 0.0
        if self.damping is not None:
            self._damp(s, self.damping[self.centre, 3:])
        if self.joints is not None:
            self.joints.pull(s, self)
        before = self.reaction[:, 3:].copy()
        self.respond(s)
        self.reaction[body, axis] = -s.f[row, axis]
        self.reaction[:, 3:] = self._moment
        for drive in self.drives:
            drive.total[3 + drive.axis] = self._moment[drive.body, drive.axis]
        if self.drives:
            self.energy["external work"] += (
                0.5 * s.dt * np.sum((before + self._moment) * s.omega[self.centre])
            )
        spread(s.x, s.a, s.alpha, self.centre, self.first, self.nodes, self.spin)

    def move(self, state: State, dt: float) -> None:
        """L_{n+1/2}, omega_{n+1/2}, R_{n+1}; raises SolverError where a body turns too far in a step."""
        s = state
        self.L += 0.5 * (s.dt + dt) * self.torque
        self.rotate(s, dt)
        if self.joints is not None:
            self.joints.close(s, self, dt)
        carry(
            s.x, s.v, s.omega, dt, self.centre, self.first, self.nodes, self.arm,
            self.q, self.principal, self.L, self.given, self.turned,
        )  # fmt: skip

    def respond(self, s: State) -> None:
        """omega_n and alpha_n under the torques at t_n."""
        respond(
            s.omega, s.alpha, s.dt, self.centre, self.q, self.principal, self.inverse,
            self.L, self.torque, self.given, self.spin, self._moment, self.kinetic,
        )  # fmt: skip

    def rotate(self, s: State, dt: float) -> None:
        """omega_{n+1/2} that goes with L_{n+1/2}."""
        angle = rotate(s.omega, dt, self.centre, self.q, self.inverse, self.L, self.given)
        if not angle <= LARGEST_ANGLE:
            what = (
                f"a rigid body turns by {angle:.3g} rad in a step of {dt:.3g}; {LARGEST_ANGLE:g} is the most"
            )
            raise SolverError(s, what, "*CONTROL_TIMESTEP LCTM makes steps shorter")

    def momentum(self, body: int) -> Array:
        """I omega_n (3,) of a body at t_n, while the time loop shows its state."""
        s, (x, y, z) = self.q[body, 0], self.q[body, 1:]
        axes = np.array(rotation_matrix(s, (x, y, z)))
        return np.asarray(axes.T @ (self.principal[body] * (axes @ self.spin[body])))

    def _damp(self, s: State, rate: Array) -> None:
        """T -= D L_n, solved for L_n = L_{n-1/2} + dt/2 T; what it takes is 1/2 (T_n + T_{n-1}) dt omega_{n-1/2}."""
        damped = (self.torque - rate * self.L) / (1.0 + 0.5 * s.dt * rate)
        now = damped - self.torque
        self.energy["damping"] -= 0.5 * s.dt * np.sum((self._damped + now) * s.omega[self.centre])
        self.torque, self._damped = damped, now


class Gather:
    """What pushes on the nodes of rigid bodies, handed to their centres."""

    name = "forces on rigid bodies"

    def __init__(self, bodies: Bodies, inverse_mass: Array) -> None:
        """`inverse_mass` (n,) of the centres."""
        self.energy: dict[str, Array] = {}
        self.bodies, self.inverse_mass = bodies, inverse_mass
        self.fixed = np.zeros_like(bodies.fixed)

    def accelerate(self, state: State) -> None:
        """f and a = F/M of the centres, and the torque about them."""
        s, b = state, self.bodies
        gather(s.x, s.f, s.moment, s.a, self.inverse_mass, b.centre, b.first, b.nodes, b.torque)

    def move(self, state: State, dt: float) -> None:
        """Nothing to do: `Bodies` moves them."""
