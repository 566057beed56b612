"""Velocities of rigid bodies at t = 0: see bodies/rigid.py for which of several cards rules."""

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.initial.velocity_rigid_body import INITIAL_VELOCITY_RIGID_BODY
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.explicit.rigid.inertia import Inertia
from vmharness.explicit.rigid.members import Member
from vmharness.explicit.rigid.motion import rigid_motion
from vmharness.explicit.rigid.numbers import lead_number


def velocities(
    deck: Deck, model: Model, found: list[Member], inertia: list[Inertia]
) -> list[tuple[Array, Array]]:
    """Velocity of the centre and angular velocity of each body at t = 0."""
    s = model.state
    given = {lead_number(deck, e, "pid"): e for e in deck.all(INITIAL_VELOCITY_RIGID_BODY)}
    velocities = []
    for member, one in zip(found, inertia, strict=True):
        rows = member.nodes
        if entry := given.get(member.number):
            pair = _vectors(entry.values, "vx", "vy", "vz"), _vectors(entry.values, "vxr", "vyr", "vzr")
        elif member.has_inertia:
            values = member.entry.values
            pair = _vectors(values, "vtx", "vty", "vtz"), _vectors(values, "vrx", "vry", "vrz")
        else:
            pair = rigid_motion(
                model.x0[rows], s.v[rows], s.omega[rows], s.mass[rows], s.inertia[rows], one.centre
            )
        velocities.append(pair)
    return velocities


def _vectors(values: dict[str, float], *names: str) -> Array:
    return np.array([values[name] for name in names])
