"""All rigid bodies of a model, as two constraints of the time loop.

`BodyForces` comes before all other constraints: these find the centres accelerated by the forces on the nodes.
`RigidBodies` comes after all others: the nodes follow the centres as those leave them.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from vmharness.explicit.rigid.bodies import Bodies
from vmharness.explicit.rigid.joints import Joints
from vmharness.explicit.state import Array, Flags, Index, State


class Drive(NamedTuple):
    """A prescribed motion of one rotation of a body, by its place among the bodies."""

    body: int
    axis: int
    total: Array  # (6,) force and moment of the motion, for its probes


class BodyForces:
    """The forces on the nodes of rigid bodies, summed at their centres."""

    name = "forces on rigid bodies"

    def __init__(self, bodies: Bodies, model_size: int) -> None:
        self.energy: dict[str, Array] = {}
        self.bodies = bodies
        self.fixed = np.zeros((model_size, 6), bool)

    def accelerate(self, state: State) -> None:
        """Set f and a = F/M of the centres, and the torque about them."""
        self.bodies.gather_forces(state)

    def move(self, state: State, dt: float) -> None:
        """Nothing to do: `RigidBodies` moves the nodes."""


class RigidBodies:
    """The motion of rigid bodies, with their joints, driven rotations and mass damping."""

    name = "rigid bodies"

    def __init__(
        self, bodies: Bodies, held: Flags, fixed: Flags, drives: Sequence[Drive], damping: Array | None,
        joints: Joints | None,
    ) -> None:  # fmt: skip
        """`held` (nb, 6): by CMO; `fixed` (n, 6): ruled by bodies; `damping` (n, 6): the rates D S of mass damping."""
        self.bodies, self.fixed, self.joints = bodies, fixed, joints
        self.drives, self.damping = drives, damping
        self.reaction = np.zeros((bodies.centre.size, 6))  # of CMO and of driven rotations on each body
        self.energy = {"external work": np.zeros(1), "damping": np.zeros(1)}
        self._held = np.nonzero(held[:, :3])  # body and axis of each held translation
        self._damped = np.zeros((bodies.centre.size, 3))  # the torque of damping

    def modes(self, state: State, held: Flags) -> Iterator[tuple[Index, Array]]:
        """The free motions of the bodies; joints, which hold some of them, are left out."""
        return self.bodies.modes(state, held)

    def accelerate(self, state: State) -> None:
        """Set omega_n and alpha_n, forces of joints, reactions, and the acceleration of the nodes at t_n."""
        s, b, (body, axis) = state, self.bodies, self._held
        row = b.centre[body]
        s.a[row, axis] = 0.0
        if self.damping is not None:
            self._damp(s, self.damping[b.centre, 3:])
        if self.joints is not None:
            self.joints.add_forces(s)
        before = self.reaction[:, 3:].copy()
        b.angular_response(s)
        self.reaction[body, axis] = -s.f[row, axis]
        self.reaction[:, 3:] = b.moment
        for drive in self.drives:
            drive.total[3 + drive.axis] = b.moment[drive.body, drive.axis]
        if self.drives:
            self.energy["external work"] += 0.5 * s.dt * np.sum((before + b.moment) * s.omega[b.centre])
        b.accelerate_nodes(s)

    def move(self, state: State, dt: float) -> None:
        """Set L_{n+1/2}, omega_{n+1/2}, R_{n+1} and the velocity of the nodes."""
        b = self.bodies
        b.L += 0.5 * (state.dt + dt) * b.torque
        b.mid_step_velocity(state, dt)
        if self.joints is not None:
            self.joints.close_gaps(state, dt)
        b.move_nodes(state, dt)

    def _damp(self, s: State, rate: Array) -> None:
        """T -= D L_n, solved for L_n = L_{n-1/2} + dt/2 T; its work is 1/2 (T_n + T_{n-1}) dt omega_{n-1/2}."""
        b = self.bodies
        damped = (b.torque - rate * b.L) / (1.0 + 0.5 * s.dt * rate)
        now = damped - b.torque
        self.energy["damping"] -= 0.5 * s.dt * np.sum((self._damped + now) * s.omega[b.centre])
        b.torque, self._damped = damped, now
