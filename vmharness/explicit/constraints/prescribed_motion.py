"""*BOUNDARY_PRESCRIBED_MOTION_NODE and _SET: nodes that follow a curve c(t) = SF LC(t - BIRTH), BIRTH <= t < DEATH.

    VAD 0, velocity        v_{n+1/2} = mean of c over the step      v_n = c(t_n)     x_n - x_0 = integral of c
    VAD 1, acceleration    a_n = c(t_n)
    VAD 2, displacement    v_{n+1/2} = (c_{n+1} - c_n)/dt           a_n = 0          x_n - x_0 = c(t_n)

Each holds exactly at every t_n. A displacement is piecewise linear: its velocity is constant between the points of the
curve. At a point an impulse changes the velocity; a_n = 0 does not show it, but the work contains it. The nodes are at
rest at t = 0, as in LS-DYNA, where v(0) = 0: the slope with which a curve begins is an impulse, too, and its work is
external work. A rotation of a rigid body alone begins with the slope, since the work of impulses is not known there.

The reaction r = m a - f is the force of the motion on its nodes. Its work is the increase of kinetic energy less the
work of the other forces,

    W = sum of 1/2 m (v_{n+1}^2 - v_n^2) - 1/2 (f_n + f_{n+1}) dt v_{n+1/2},

which is 1/2 (r_n + r_{n+1}) dt v_{n+1/2} to second order, and balances the energy at impulses too.
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.boundary.prescribed_motion import (
    BOUNDARY_PRESCRIBED_MOTION_NODE,
    BOUNDARY_PRESCRIBED_MOTION_SET,
)
from vmharness.deck.rule import above, among, at_least, only
from vmharness.deck.support import supports
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.model.curve import Curve, time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index, State
from vmharness.mesh.dof import place
from vmharness.mesh.sets import node_set
from vmharness.mesh.supports import supported

KEYWORDS = (BOUNDARY_PRESCRIBED_MOTION_NODE, BOUNDARY_PRESCRIBED_MOTION_SET)

MOTION = {
    "dof": among(1, 2, 3, 5, 6, 7),
    "vad": among(0, 1, 2),
    "lcid": above(0),
    "vid": only(0),
    "death": above(0.0),
    "birth": at_least(0.0),
}

SUPPORTS = tuple(supports(keyword, **MOTION) for keyword in KEYWORDS)

VELOCITY, ACCELERATION, DISPLACEMENT = 0, 1, 2  # VAD


def build(deck: Deck, model: Model) -> None:
    """Add a constraint for each card, in the deck's order; a degree of freedom may be prescribed only once."""
    entries = [entry for entry in deck.entries if entry.keyword in KEYWORDS]
    if not entries:
        return
    held, moved = supported(deck, model), np.zeros((model.ids.size, 6), bool)
    for number, entry in enumerate(entries, 1):
        rows, dof = _nodes(deck, model, entry), place(entry)
        for flags, other in ((held, "a support"), (moved, "another prescribed motion")):
            for row in rows[flags[rows, dof]]:
                raise entry.error(
                    "dof", f"node {model.ids[row]} is already prescribed by {other} in this direction"
                )
        moved[rows, dof] = True
        model.constraints.append(build_motion(deck, model, entry, rows, number))


def _nodes(deck: Deck, model: Model, entry: Entry) -> Index:
    if entry.keyword is BOUNDARY_PRESCRIBED_MOTION_SET:
        return node_set(deck, model, entry, "nsid")
    return np.array([model.row(entry, "nid", entry.nid)], np.intp)


def build_motion(deck: Deck, model: Model, entry: Entry, rows: Index, number: int) -> "PrescribedMotion":
    """The motion that `entry` prescribes for nodes (m,); raises DeckError for a motion that is impossible."""
    if entry.death <= entry.birth:
        raise entry.error("death", f"the motion would end before its birth at {entry.birth:g}")
    curve = time_curve(deck, entry, "lcid", min(model.end_time, entry.death) - entry.birth)
    if entry.vad == DISPLACEMENT and curve.first != 0.0:
        raise entry.error(
            "lcid", f"a displacement that begins with a jump, {curve.first:g}; let it begin at 0"
        )
    name, dof = f"prescribed motion {number}", place(entry)
    motion = PrescribedMotion(name, rows, dof, entry.vad, entry.sf, curve, entry.birth, entry.death)
    motion.begin(model)
    return motion


class PrescribedMotion:
    """One degree of freedom (0 to 5: x, y, z and rotations) of nodes (m,) that follows c(t) = sf curve(t - birth)."""

    def __init__(
        self, name: str, nodes: Index, dof: int, vad: int, sf: float, curve: Curve, birth: float, death: float
    ) -> None:
        self.name, self.nodes, self.dof, self.axis, self.vad = name, nodes, dof, dof % 3, vad
        self.sf, self.curve, self.birth, self.death = sf, curve, birth, death
        self.energy = {"external work": np.zeros(1)}
        self.reaction = np.zeros(nodes.size)  # (m,)
        self.total = np.zeros(6)  # its sum, at `dof`
        self.drives = False  # true if the motion ruled the last step
        self.velocity = np.zeros(nodes.size)  # (m,) v_n
        self.force = np.zeros(nodes.size)  # (m,) f_n

    def begin(self, model: Model, at_rest: bool = True) -> None:
        """Set `fixed`, where no mass is needed as the motion lasts throughout; set the velocity at t = 0.

        A displacement begins `at_rest`, or with the slope of its curve.
        """
        self.fixed = np.zeros((model.ids.size, 6), bool)
        self.fixed[self.nodes, self.dof] = self.throughout(model.end_time)
        if self.birth == 0.0 and self.vad != ACCELERATION:
            v = self.curve(0.0) if self.vad == VELOCITY else 0.0 if at_rest else self.curve.slope()
            self._arrays(model.state)[0][self.nodes, self.axis] = self.sf * v

    def throughout(self, end_time: float) -> bool:
        """True if the motion lasts from the beginning to the end of the run."""
        return self.birth == 0.0 and self.death > end_time

    def accelerate(self, state: State) -> None:
        """Set a_n and the reaction, and add the work of the step that led to t_n."""
        drives = self.birth <= state.t < self.death
        t = state.t - self.birth
        value = self.sf * self.curve(t) if drives and self.vad != DISPLACEMENT else 0.0
        follows_velocity = self.vad == VELOCITY and state.dt > 0.0
        if self.vad == VELOCITY and not follows_velocity:
            value = self.sf * self.curve.slope()
        impose(
            *self._arrays(state), self.nodes, self.axis, state.dt, drives, self.drives, follows_velocity, value,
            self.reaction, self.velocity, self.force, self.energy["external work"],
        )  # fmt: skip
        self.total[self.dof] = self.reaction.sum()

    def move(self, state: State, dt: float) -> None:
        """Set v_{n+1/2} so that the displacement at t_{n+1} is that of the curve, or the integral of its velocity."""
        self.drives = self.birth <= state.t < self.death
        if self.drives and self.vad != ACCELERATION:
            t = state.t - self.birth
            mean = self.curve.mean if self.vad == VELOCITY else self.curve.rate
            self._arrays(state)[0][self.nodes, self.axis] = self.sf * mean(t, t + dt)

    def _arrays(self, s: State) -> tuple[Array, Array, Array, Array]:
        """v, a, f, m, or the same quantities of rotation."""
        return (s.v, s.a, s.f, s.mass) if self.dof < 3 else (s.omega, s.alpha, s.moment, s.inertia)


@kernel
def impose(
    v: Array, a: Array, f: Array, m: Array, nodes: Index, j: int, dt: float, drives: bool, drove: bool,
    is_velocity: bool, value: float, reaction: Array, velocity: Array, force: Array, work: Array,
) -> None:  # fmt: skip
    """Set a_n = `value`, or the a_n of v_n = `value`; set r_n = m a_n - f_n, and add its work."""
    for k in range(nodes.size):
        i = nodes[k]
        free = v[i, j] + 0.5 * dt * a[i, j]
        if drives:
            a[i, j] = (value - v[i, j]) / (0.5 * dt) if is_velocity else value
        reaction[k] = m[i] * a[i, j] - f[i, j] if drives else 0.0
        now = v[i, j] + 0.5 * dt * a[i, j]
        if drove:
            work[0] += 0.5 * m[i] * (now**2 - velocity[k] ** 2) - 0.5 * (force[k] + f[i, j]) * dt * v[i, j]
        elif drives:
            work[0] += 0.5 * m[i] * (now**2 - free**2)
        velocity[k], force[k] = now, f[i, j]
