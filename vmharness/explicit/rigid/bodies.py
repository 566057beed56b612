"""The arrays of all rigid bodies of a model, and the parts of their step."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.error import SolverError
from vmharness.explicit.kernels.rotation import rotation_matrix
from vmharness.explicit.rigid.integrate import (
    accelerate_nodes,
    angular_response,
    gather_forces,
    mid_step_velocity,
    move_nodes,
)
from vmharness.explicit.state import Array, Flags, Index, State

LARGEST_ANGLE = 1.0  # of a step


@dataclass
class Bodies:
    """Rigid bodies (nb,) by their arrays, as integrate.py describes them; consistent units."""

    numbers: NDArray[np.int64]  # (nb,) of the deck
    centre: Index  # (nb,) rows of the state's arrays
    first: Index  # (nb + 1,)
    nodes: Index  # (m,)
    arm: Array  # (m, 3)
    q: Array  # (nb, 4)
    principal: Array  # (nb, 3)
    inverse: Array  # (nb, 3)
    L: Array  # (nb, 3) angular momentum, L_{n-1/2} while forces are added
    inverse_mass: Array  # (n,) 1/M at the centres
    given: Flags  # (nb, 3) global components of rotation that are held or driven

    def __post_init__(self) -> None:
        count = self.centre.size
        self.torque = np.zeros((count, 3))  # T_n
        self.spin = np.zeros((count, 3))  # omega_n
        self.angle = np.zeros((count, 3))  # int omega dt
        self.moment = np.zeros((count, 3))  # reaction at the given rotations
        self.kinetic = np.zeros(1)  # energy of rotation

    @property
    def owner(self) -> Index:
        """The body (m,) of each of the nodes."""
        return np.repeat(np.arange(self.centre.size), np.diff(self.first))

    def slices(self) -> Iterator[slice]:
        """Where the nodes of each body are in `nodes` and `arm`."""
        return (slice(*pair) for pair in pairwise(self.first.tolist()))

    def modes(self, s: State, held: Flags) -> Iterator[tuple[Index, Array]]:
        """For each body its nodes (m,) and its free motions of unit mass, as velocities (m, 6, k) of the nodes.

        Translations e_i / sqrt(M), and rotations by the principal axes w_i / sqrt(I_i) of the inertia in the free
        directions. `held` (n, 6): degrees of freedom that constraints rule.
        """
        for b, (c, place) in enumerate(zip(self.centre, self.slices(), strict=True)):
            nodes = self.nodes[place]
            axes = np.array(rotation_matrix(self.q[b, 0], tuple(self.q[b, 1:]))).T
            tensor = axes @ (self.principal[b][:, None] * axes.T)
            turns = np.flatnonzero(~self.given[b])
            moments, w = np.linalg.eigh(tensor[np.ix_(turns, turns)])
            some = moments > 1e-12 * self.principal[b].max()
            rotations = np.zeros((3, some.sum()))
            rotations[turns] = w[:, some] / np.sqrt(moments[some])
            shifts = np.eye(3)[:, ~held[c, :3]] * np.sqrt(self.inverse_mass[c])
            r = s.x[nodes] - s.x[c]
            made = np.zeros((nodes.size, 6, shifts.shape[1] + rotations.shape[1]))
            made[:, :3, : shifts.shape[1]] = shifts
            made[:, :3, shifts.shape[1] :] = np.cross(rotations.T[None], r[:, None]).transpose(0, 2, 1)
            made[:, 3:, shifts.shape[1] :] = rotations
            yield nodes, made

    def gather_forces(self, s: State) -> None:
        """Sum the forces on nodes at the centres: f, a = F/M, and the torque T_n."""
        gather_forces(
            s.x, s.f, s.moment, s.a, self.inverse_mass, self.centre, self.first, self.nodes, self.torque
        )

    def angular_response(self, s: State) -> None:
        """Set omega_n, alpha_n and the reaction at given rotations, under the torque T_n."""
        angular_response(
            s.omega, s.alpha, s.dt, self.centre, self.q, self.principal, self.inverse,
            self.L, self.torque, self.given, self.spin, self.moment, self.kinetic,
        )  # fmt: skip

    def accelerate_nodes(self, s: State) -> None:
        """Set the acceleration of the nodes at t_n."""
        accelerate_nodes(s.x, s.a, s.alpha, self.centre, self.first, self.nodes, self.spin)

    def mid_step_velocity(self, s: State, dt: float) -> None:
        """Set omega_{n+1/2} that belongs to L_{n+1/2}; raises SolverError where a body rotates too far in a step."""
        angle = mid_step_velocity(s.omega, dt, self.centre, self.q, self.inverse, self.L, self.given)
        if not angle <= LARGEST_ANGLE:
            what = (
                f"a rigid body turns by {angle:.3g} rad in a step of {dt:.3g}; {LARGEST_ANGLE:g} is the most"
            )
            raise SolverError(s, what, "*CONTROL_TIMESTEP LCTM makes steps shorter")

    def move_nodes(self, s: State, dt: float) -> None:
        """Set R_{n+1} and the velocity of the nodes over the step."""
        move_nodes(
            s.x, s.v, s.omega, dt, self.centre, self.first, self.nodes, self.arm,
            self.q, self.principal, self.L, self.given, self.angle,
        )  # fmt: skip

    def angular_momentum(self, body: int) -> Array:
        """I omega_n (3,) of a body at t_n, while the time loop yields its state."""
        s, (x, y, z) = self.q[body, 0], self.q[body, 1:]
        axes = np.array(rotation_matrix(s, (x, y, z)))
        return np.asarray(axes.T @ (self.principal[body] * (axes @ self.spin[body])))
