"""Joints between rigid bodies, exact at every t_n: no penalty, and no drift.

At t_n multipliers make the relative acceleration of the joined points zero: these are the forces of the joints. The
impulses over the step are then corrected until the points meet at t_{n+1}, with the directions of t_n,

    x_1(t_{n+1}) = x_2(t_{n+1}),        v += M^-1 d P,  L += r x d P

which is the SHAKE scheme of order 2, that keeps momentum and angular momentum, and does no work. A spherical joint
holds its points along x, y, z; a revolute joint holds a second pair on its axis, across that axis alone. LS-DYNA's
default is a penalty that approaches this.

Source: J.-P. Ryckaert, G. Ciccotti, H. J. C. Berendsen, Numerical integration of the cartesian equations of motion of
a system with constraints, Journal of Computational Physics 23 (1977) 327-341.
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vmharness.explicit.error import SolverError
from vmharness.explicit.model.state import Array, State
from vmharness.explicit.rigid.couple import couple, gaps, push, relative

if TYPE_CHECKING:
    from vmharness.explicit.rigid.bodies import Bodies

Index = NDArray[np.intp]

ITERATIONS = 30
ROUND_OFF = 1e-14  # of the forces, and of the arms


class Pair(NamedTuple):
    """Two points that a joint holds together, as places in the list of all nodes of bodies."""

    joint: int  # which joint, from 0
    points: tuple[int, int]
    axis: tuple[int, int] | None  # held across the line between these places alone, else along x, y and z


class Joints:
    """All joints of a model; `force` and `moment` (nj, 3) act on the body of the first node, moment about that node."""

    def __init__(self, pairs: list[Pair], body: Index, movable: Array) -> None:
        """`body` (m,): whose each place is; `movable` (nb, 3): 1/M, or 0 where the centre is held."""
        self.pairs, self.movable = pairs, movable
        rows = [pair for pair in pairs for _ in range(3 if pair.axis is None else 2)]
        self.joint = np.array([pair.joint for pair in rows])
        self.point = np.array([pair.points for pair in rows], np.intp)  # (nr, 2)
        self.body = body[self.point]  # (nr, 2)
        count = len(rows)
        self.d = np.zeros((count, 3))
        self.total = np.zeros((1 + int(self.joint.max()), 6))  # force and moment of each joint
        self._first = np.array(
            [next(p.points[0] for p in pairs if p.joint == j) for j in self.joint], np.intp
        )
        self._turning, self._spinning = np.zeros((count, 2, 3)), np.zeros((count, 2, 3))
        self._K, self._off = np.zeros((count, count)), np.zeros(count)

    def pull(self, s: State, bodies: "Bodies") -> None:
        """Add the joints' forces at t_n to the accelerations of the centres and to the torques."""
        self._aim(s, bodies)
        b, total = bodies, np.zeros(len(self.d))
        couple(
            s.x, b.centre, b.nodes, self.point, self.body, self.d, self.movable, b.q, b.inverse, b.given,
            self._turning, self._spinning, self._K,
        )  # fmt: skip
        # A direction that others hold already has no mobility: it takes no force.
        self._inverse = np.linalg.pinv(self._K, rcond=1e-10, hermitian=True)
        for _ in range(ITERATIONS):
            bodies.respond(s)
            relative(
                s.x, s.a, s.alpha, b.centre, b.nodes, self.point, self.body, self.d, b.spin, self._off
            )  # fmt: skip
            by = -self._inverse @ self._off
            total += by
            push(s.a, b.torque, b.centre, self.body, self.d, self.movable, self._turning, by)
            if np.abs(by).max() <= ROUND_OFF * np.abs(total).max():
                break
        self._report(s, bodies, total)

    def close(self, s: State, bodies: "Bodies", dt: float) -> None:
        """Correct v and L of the step until the points meet at its end; raises SolverError where they cannot."""
        b, reach = bodies, ROUND_OFF * max(1e-300, float(np.abs(bodies.arm).max()))
        reach = max(reach, 1e-15 * float(np.abs(s.x[b.centre]).max()))
        for _ in range(ITERATIONS):
            gaps(
                s.x, s.v, s.omega, dt, b.centre, b.arm, self.point, self.body, self.d, b.q, self._off
            )  # fmt: skip
            if np.abs(self._off).max() <= reach:
                return
            by = -self._inverse @ self._off / dt
            push(s.v, b.L, b.centre, self.body, self.d, self.movable, self._turning, by)
            bodies.rotate(s, dt)
        raise SolverError(s, f"a joint stays open by {np.abs(self._off).max():.3g}")

    def _aim(self, s: State, bodies: "Bodies") -> None:
        """The directions d at t_n."""
        at, row = s.x[bodies.nodes], 0
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

    def _report(self, s: State, bodies: "Bodies", multiplier: Array) -> None:
        """Force and moment of each joint at t_n; the centres take the forces."""
        force = multiplier[:, None] * self.d
        arm = s.x[bodies.nodes[self.point[:, 0]]] - s.x[bodies.nodes[self._first]]
        self.total[:] = 0.0
        np.add.at(self.total, self.joint, np.hstack([force, np.cross(arm, force)]))
        np.add.at(s.f, bodies.centre[self.body[:, 0]], force)
        np.add.at(s.f, bodies.centre[self.body[:, 1]], -force)
