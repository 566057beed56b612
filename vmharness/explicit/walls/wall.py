"""A planar rigid wall as a constraint."""

import math

import numpy as np

from vmharness.explicit.state import Array, Index, State
from vmharness.explicit.walls.face import NORMAL
from vmharness.explicit.walls.impulse import add_impulses, add_wall_forces


class PlanarWall:
    """A wall that keeps `nodes` (nt,) in front of its `face` (5, 3) from `birth` to `death`."""

    def __init__(
        self, number: int, nodes: Index, face: Array, friction: float, birth: float, death: float, mass: float,
        velocity: float,
    ) -> None:  # fmt: skip
        """`friction` is infinite if nothing slides, `mass` is infinite if the wall stands; `velocity` is along n."""
        self.number, self.name = number, f"rigid wall {number}"
        self.nodes, self.face, self.friction, self.birth, self.death = nodes, face, friction, birth, death
        self.inverse_mass = 1.0 / mass
        self.normal = face[NORMAL]
        self.motion = np.array([0.0, velocity, 0.0])  # displacement at t_n, velocity at t_{n-1/2}, A at t_n
        self.forces = np.zeros((nodes.size, 3))  # r_i at t_n on the nodes, with friction
        self.trial = np.full(nodes.size, np.inf)
        self.in_front = np.zeros(nodes.size, bool)  # see impulse.py
        self.step_impulse = np.zeros(3)  # the sum of the impulses p_i of the last step
        self.force = np.zeros(3)  # on all nodes: forces at t_n, and impulses divided by their step
        self.impulse_before = np.zeros(3)  # of forces and impulses on all nodes, until t_{n-1/2}
        self.impulse = np.zeros(3)  # until t_n
        kinetic = 0.5 * mass * velocity**2 if math.isfinite(mass) else 0.0
        self.energy = {"rigid wall": np.full(1, kinetic)}

    def begin(self, x: Array) -> None:
        """Set `reach` from the extent of the model's coordinates `x` (n, 3); fix no degree of freedom."""
        self.reach = 1e-9 * float(np.ptp(np.vstack([x, self.face[:1]]), axis=0).max())
        self.fixed = np.zeros((len(x), 6), bool)

    def accelerate(self, state: State) -> None:
        """Set forces and impulse at t_n, and add the work of the step that led there."""
        s = state
        self.energy["rigid wall"] -= add_wall_forces(
            s.x, s.v, s.a, s.mass, s.dt, self.nodes, self.face, self._reach(s.t), self.motion, self.inverse_mass,
            self.friction, self.forces, self.trial,
        )  # fmt: skip
        self.force[:] = self.forces.sum(axis=0)
        self.impulse[:] = self.impulse_before + 0.5 * s.dt * self.force
        if s.dt > 0.0:
            self.force += self.step_impulse / s.dt

    def move(self, state: State, dt: float) -> None:
        """Set the impulses of the step `dt` that follows, and the motion of the wall."""
        s, mean_dt = state, 0.5 * (state.dt + dt)
        self.energy["rigid wall"] -= add_impulses(
            s.x, s.v, s.a, s.mass, mean_dt, dt, self.nodes, self.face, self._reach(s.t), self.motion,
            self.inverse_mass, self.friction, self.forces, self.trial, self.in_front, self.step_impulse,
        )  # fmt: skip
        self.impulse_before += mean_dt * self.forces.sum(axis=0) + self.step_impulse

    def velocity(self, state: State) -> float:
        """The velocity of the wall along n at t_n."""
        return float(self.motion[1] + 0.5 * state.dt * self.motion[2])

    def _reach(self, t: float) -> float:
        return self.reach if self.birth <= t < self.death else -math.inf
