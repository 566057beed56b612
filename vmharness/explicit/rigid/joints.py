"""Joints between rigid bodies, exact at every t_n: without penalty and without drift.

At t_n multipliers make the relative acceleration of the joined points zero: these are the forces of the joints. The
impulses over the step are then corrected until the points meet at t_{n+1}, along the directions of t_n,

    x_1(t_{n+1}) = x_2(t_{n+1}),        v += M^-1 d P,  L += r x d P

which is the SHAKE scheme of order 2. It conserves momentum and angular momentum, and does no work. A spherical joint
holds its points together along x, y, z; a revolute joint holds a second pair of points, on its axis, together across
that axis. LS-DYNA's default is a penalty, which approaches this.

Source: J.-P. Ryckaert, G. Ciccotti, H. J. C. Berendsen, Numerical integration of the cartesian equations of motion of
a system with constraints, Journal of Computational Physics 23 (1977) 327-341.
"""

from typing import NamedTuple

import numpy as np

from vmharness.explicit.error import SolverError
from vmharness.explicit.rigid.bodies import Bodies
from vmharness.explicit.rigid.joint_equations import (
    apply_multipliers,
    constraint_matrix,
    end_gaps,
    relative_acceleration,
)
from vmharness.explicit.state import Array, State

ITERATIONS = 30
ROUND_OFF = 1e-14  # of the forces, and of the arms


class Pair(NamedTuple):
    """Two points that a joint holds together, as places in the list of all nodes of bodies."""

    joint: int  # which joint, from 0
    points: tuple[int, int]
    axis: tuple[int, int] | None  # held together across the line between these places, or along x, y and z


class Joints:
    """All joints of a model; `total` (nj, 6) is force and moment on the body of the first node, about that node."""

    def __init__(self, pairs: list[Pair], bodies: Bodies, movable: Array) -> None:
        """`movable` (nb, 3): 1/M, or 0 where the centre is held."""
        self.pairs, self.bodies, self.movable = pairs, bodies, movable
        rows = [pair for pair in pairs for _ in range(3 if pair.axis is None else 2)]
        self.joint = np.array([pair.joint for pair in rows])
        self.point = np.array([pair.points for pair in rows], np.intp)  # (nr, 2)
        self.body = bodies.owner[self.point]  # (nr, 2)
        count = len(rows)
        self.d = np.zeros((count, 3))
        self.total = np.zeros((1 + int(self.joint.max()), 6))
        self._first = np.array(
            [next(p.points[0] for p in pairs if p.joint == j) for j in self.joint], np.intp
        )
        self._lever, self._response = np.zeros((count, 2, 3)), np.zeros((count, 2, 3))
        self._K, self._residual = np.zeros((count, count)), np.zeros(count)

    def add_forces(self, s: State) -> None:
        """Add the joints' forces at t_n to the accelerations of the centres and to the torques."""
        b, total = self.bodies, np.zeros(len(self.d))
        self._set_directions(s)
        constraint_matrix(
            s.x, b.centre, b.nodes, self.point, self.body, self.d, self.movable, b.q, b.inverse, b.given,
            self._lever, self._response, self._K,
        )  # fmt: skip
        # K is singular where other rows, or held directions, determine the motion along d already: no force there.
        self._inverse = np.linalg.pinv(self._K, rcond=1e-10, hermitian=True)
        for _ in range(ITERATIONS):
            b.angular_response(s)
            relative_acceleration(
                s.x, s.a, s.alpha, b.centre, b.nodes, self.point, self.body, self.d, b.spin, self._residual
            )
            correction = -self._inverse @ self._residual
            total += correction
            apply_multipliers(
                s.a, b.torque, b.centre, self.body, self.d, self.movable, self._lever, correction
            )
            if np.abs(correction).max() <= ROUND_OFF * np.abs(total).max():
                break
        self._set_totals(s, total)

    def close_gaps(self, s: State, dt: float) -> None:
        """Correct v and L of the step until the points meet at its end; raises SolverError where they cannot."""
        b, allowed = self.bodies, ROUND_OFF * max(1e-300, float(np.abs(self.bodies.arm).max()))
        allowed = max(allowed, 1e-15 * float(np.abs(s.x[b.centre]).max()))
        for _ in range(ITERATIONS):
            end_gaps(
                s.x, s.v, s.omega, dt, b.centre, b.arm, self.point, self.body, self.d, b.q, self._residual
            )
            if np.abs(self._residual).max() <= allowed:
                return
            impulse = -self._inverse @ self._residual / dt
            apply_multipliers(s.v, b.L, b.centre, self.body, self.d, self.movable, self._lever, impulse)
            b.mid_step_velocity(s, dt)
        raise SolverError(s, f"a joint stays open by {np.abs(self._residual).max():.3g}")

    def _set_directions(self, s: State) -> None:
        """Set the directions d at t_n."""
        at, row = s.x[self.bodies.nodes], 0
        for pair in self.pairs:
            if pair.axis is None:
                d = np.eye(3)
            else:
                along = at[pair.axis[1]] - at[pair.axis[0]]
                first = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
                d = np.array([first, np.cross(along, first)])
                d /= np.linalg.norm(d, axis=1, keepdims=True)
            self.d[row : row + len(d)] = d
            row += len(d)

    def _set_totals(self, s: State, multiplier: Array) -> None:
        """Set force and moment of each joint at t_n, and add the forces to those of the centres."""
        b, force = self.bodies, multiplier[:, None] * self.d
        arm = s.x[b.nodes[self.point[:, 0]]] - s.x[b.nodes[self._first]]
        self.total[:] = 0.0
        np.add.at(self.total, self.joint, np.hstack([force, np.cross(arm, force)]))
        np.add.at(s.f, b.centre[self.body[:, 0]], force)
        np.add.at(s.f, b.centre[self.body[:, 1]], -force)
