"""Velocities of rigid bodies at t = 0.

Later rules overrule earlier ones: a body has the rigid motion nearest to the velocities of its nodes; or the velocity
on the _INERTIA cards, zeros too; or that of *INITIAL_VELOCITY_RIGID_BODY.
"""

import numpy as np

from vmharness.deck import Deck, Entry, Finding
from vmharness.deck.keywords.initial.velocity_rigid_body import INITIAL_VELOCITY_RIGID_BODY
from vmharness.deck.rule import only
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.rigid_bodies import lead_number
from vmharness.explicit.rigid.body import RigidBody
from vmharness.explicit.rigid.inertia import Inertia, inertia_of_points
from vmharness.explicit.state import Array

SUPPORTS = (supports(INITIAL_VELOCITY_RIGID_BODY, icid=only(0)),)


def body_velocities(
    deck: Deck, model: Model, bodies: list[RigidBody], inertia: list[Inertia]
) -> list[tuple[Array, Array]]:
    """Velocity of the centre (3,) and angular velocity (3,) of each body at t = 0."""
    s = model.state
    cards = {lead_number(deck, e, "pid"): e for e in deck.all(INITIAL_VELOCITY_RIGID_BODY)}
    velocities = []
    for body, one in zip(bodies, inertia, strict=True):
        rows = body.nodes
        if entry := cards.get(body.number):
            pair = _vector(entry, "vx", "vy", "vz"), _vector(entry, "vxr", "vyr", "vzr")
        elif body.inertia_given:
            pair = _vector(body.entry, "vtx", "vty", "vtz"), _vector(body.entry, "vrx", "vry", "vrz")
            if s.v[rows].any() or s.omega[rows].any():
                model.idle.append(_overruled(body))
        else:
            pair = nearest_rigid_motion(
                model.x0[rows], s.v[rows], s.omega[rows], s.mass[rows], s.inertia[rows], one.centre
            )
        velocities.append(pair)
    return velocities


def nearest_rigid_motion(
    x: Array, v: Array, omega: Array, mass: Array, rotary: Array, at: Array
) -> tuple[Array, Array]:
    """The rigid motion with the momentum and the angular momentum of points: velocity at `at` (3,), spin (3,).

        v_c = sum m v / M        omega = I^-1 sum (r x m v + J omega_k)

    `x`, `v`, `omega` (m, 3); `mass`, `rotary` (m,). If no point has mass, all have the same weight. A line of points
    does not spin about itself.
    """
    weight = mass if mass.any() else np.ones_like(mass)
    inertia = inertia_of_points(x, weight, rotary)
    linear = weight @ v / inertia.mass
    momentum = np.cross(x - inertia.centre, weight[:, None] * v).sum(axis=0) + rotary @ omega
    spin = np.linalg.pinv(inertia.tensor, rcond=1e-12, hermitian=True) @ momentum
    return linear + np.cross(spin, at - inertia.centre), spin


def _overruled(body: RigidBody) -> Finding:
    """What there is to say of initial velocities that the nodes of a body have, and the body has not."""
    what = "overrules the *INITIAL_VELOCITY cards for the nodes of this rigid body; a blank card is zero velocity"
    return Finding(body.entry.error("vtx", what), idle=True)


def _vector(entry: Entry, *names: str) -> Array:
    return np.array([entry.values[name] for name in names])
