"""*LOAD_BODY_X, _Y, _Z and _RX, _RY, _RZ: inertial forces in a base that accelerates or rotates.

    _X    f = -m SF LC(t) along x                                       base acceleration
    _RX   f = m omega^2 r, omega = SF LC(t), r from the axis to x_n     base rotation: centrifugal, outward

A positive acceleration gives a force toward the negative axis (d'Alembert): with +386 on *LOAD_BODY_Z a ball falls
toward -z. The axis of _RX, _RY, _RZ is parallel to x, y, z and passes through (XC, YC, ZC). Euler and Coriolis forces
are left out: the load is for a body at rest in the rotating base, and for a curve of omega that varies slowly.

*LOAD_BODY_PARTS restricts all of these to the nodes of a part set, with all their mass.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.load.body import (
    LOAD_BODY_PARTS,
    LOAD_BODY_RX,
    LOAD_BODY_RY,
    LOAD_BODY_RZ,
    LOAD_BODY_X,
    LOAD_BODY_Y,
    LOAD_BODY_Z,
)
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import above, no_effect, only
from vmharness.deck.support import supports
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.model.curve import Curve, time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.sets import masses_of_parts
from vmharness.explicit.state import Array, Index, State
from vmharness.mesh.sets import nodes_of_parts, part_set

NAME = "body load"

ALONG = (LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z)
ABOUT = (LOAD_BODY_RX, LOAD_BODY_RY, LOAD_BODY_RZ)
CURVE = {"lcid": above(0), "lciddr": no_effect("of dynamic relaxation"), "cid": only(0)}
CENTRE = {name: no_effect("acts on rotations") for name in ("xc", "yc", "zc")}

SUPPORTS = (
    *(supports(keyword, **CURVE, **CENTRE) for keyword in ALONG),
    *(supports(keyword, **CURVE) for keyword in ABOUT),
    supports(LOAD_BODY_PARTS),
)


def build(deck: Deck, model: Model) -> None:
    """Add a force for each *LOAD_BODY_... of the deck."""
    nodes = _nodes(deck, model)
    for axis, keyword in enumerate(ALONG):
        for entry in deck.all(keyword):
            curve = time_curve(deck, entry, "lcid", model.end_time)
            model.forces.append(BodyLoad(f"*{keyword.name}", nodes, axis, entry.sf, curve))
    for axis, keyword in enumerate(ABOUT):
        for entry in deck.all(keyword):
            curve = time_curve(deck, entry, "lcid", model.end_time)
            centre = np.array([entry.xc, entry.yc, entry.zc])
            model.forces.append(Centrifugal(f"*{keyword.name}", nodes, axis, centre, entry.sf, curve))


def _nodes(deck: Deck, model: Model) -> Index:
    """All nodes, or those of *LOAD_BODY_PARTS; a node shared with another part is an error: its mass is not divided."""
    chosen = deck.first(LOAD_BODY_PARTS)
    if chosen is None:
        return np.arange(model.ids.size)
    pids = part_set(deck, chosen, "psid")
    nodes = masses_of_parts(deck, model, pids)
    if not nodes.size:
        raise chosen.error("psid", "no part of the set has elements: body loads would act on nothing")
    others = nodes_of_parts(deck, model, {part.pid for part in deck.all(PART)} - pids)
    for row in np.intersect1d(nodes, others):
        raise chosen.error("psid", f"node {model.ids[row]} belongs to another part as well; not supported")
    return nodes


class BodyLoad:
    """f = -m SF LC(t) along one axis, on `nodes` (m,)."""

    def __init__(self, name: str, nodes: Index, axis: int, sf: float, curve: Curve) -> None:
        self.name, self.nodes, self.axis, self.sf, self.curve = name, nodes, axis, sf, curve
        self.energy = {"external work": np.zeros(1)}
        self.acceleration = -sf * curve(0.0)

    def add(self, state: State) -> None:
        """f += m b, and the work 1/2 m (b_n + b_{n+1}) dt v_{n+1/2}."""
        before, self.acceleration = self.acceleration, -self.sf * self.curve(state.t)
        uniform_force(
            state.f, state.v, state.mass, self.nodes, self.axis, before, self.acceleration, state.dt,
            self.energy["external work"],
        )  # fmt: skip


class Centrifugal:
    """f = m (SF LC(t))^2 r outward from an axis parallel to x, y or z through `centre` (3,), on `nodes` (m,)."""

    def __init__(self, name: str, nodes: Index, axis: int, centre: Array, sf: float, curve: Curve) -> None:
        self.name, self.nodes, self.axis, self.centre = name, nodes, axis, centre
        self.sf, self.curve = sf, curve
        self.energy = {"external work": np.zeros(1)}
        self.square = (sf * curve(0.0)) ** 2  # omega^2

    def add(self, state: State) -> None:
        """f += m omega^2 r at t_n, and the work 1/2 (f_n + f_{n+1}) dt v_{n+1/2}."""
        before, self.square = self.square, (self.sf * self.curve(state.t)) ** 2
        centrifugal_force(
            state.f, state.x, state.v, state.mass, self.nodes, self.axis, self.centre,
            before, self.square, state.dt, self.energy["external work"],
        )  # fmt: skip


@kernel
def uniform_force(
    f: Array,
    v: Array,
    mass: Array,
    nodes: Index,
    axis: int,
    before: float,
    now: float,
    dt: float,
    work: Array,
) -> None:
    """Add m `now` along `axis`, the acceleration at t_n, and the work of the step dt before, with v_{n-1/2}."""
    momentum = 0.0
    for i in nodes:
        f[i, axis] += mass[i] * now
        momentum += mass[i] * v[i, axis]
    work[0] += 0.5 * (before + now) * dt * momentum


@kernel
def centrifugal_force(
    f: Array, x: Array, v: Array, mass: Array, nodes: Index, axis: int, centre: Array,
    before: float, now: float, dt: float, work: Array,
) -> None:  # fmt: skip
    """Add m `now` r, with `now` and `before` the omega^2 at the ends of the step dt, which began at x - dt v."""
    for j in range(3):
        if j != axis:
            for i in nodes:
                r, step = x[i, j] - centre[j], dt * v[i, j]
                f[i, j] += mass[i] * now * r
                work[0] += 0.5 * mass[i] * (before * (r - step) + now * r) * step
