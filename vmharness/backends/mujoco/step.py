"""The time step that the deck asks for: TSSFAC times the critical one, at most that of the curve LCTM.

The critical step is the least of 2/omega of springs and contacts, and of L/c of trusses and held shells.
"""

import numpy as np

from vmharness.backends.mujoco.model import Model
from vmharness.deck import Entry
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points

FREE = 1000  # steps of bodies that nothing limits


def step(model: Model) -> float:
    """The constant step of the run."""
    timestep = model.deck.first(CONTROL_TIMESTEP) or Entry.of_defaults(CONTROL_TIMESTEP)
    found = [timestep.tssfac * critical for critical in (*model.steps, *_stiff(model), *_contacts(model))]
    if timestep.lctm:
        curve = model.deck.find(DEFINE_CURVE, lcid=timestep.lctm, referred_by=(timestep, "lctm"))
        found.append(float(points(curve)[1].min()))
    return min(found, default=model.deck.one(CONTROL_TERMINATION).endtim / FREE)


def _stiff(model: Model) -> list[float]:
    """2/omega_max with the bound of Gershgorin, omega^2 <= sum_j |K_ij|/m_i: a held neighbour has no column."""
    total = np.zeros(model.mass.size)
    for tendon in model.tendons:
        moving = [row for row in tendon.ends if model.moves(row)]
        for row in moving:
            total[row] += len(moving) * tendon.stiffness
    rows = np.flatnonzero(total).tolist()
    return [2.0 / float(np.sqrt(total[row] / model.mass[row])) for row in rows]


def _contacts(model: Model) -> list[float]:
    """2/omega of each mass on its contact."""
    return [
        2.0 * float(np.sqrt(model.mass[row] / contact.stiffness))
        for contact in model.contacts
        for row in contact.rows
    ]
