"""Nodal forces and accelerations of the base, by curves.

A base acceleration that is constant is the gravity of the model, with the opposite sign; one that varies acts as the
force -m SF LC(t) at the centre of each body. Curves are evaluated at the stages of the Runge-Kutta method.
"""

import numpy as np

from vmharness.backends._translation.loads import ALONG, FORCES, curve, loaded
from vmharness.backends.mujoco.model import Load, Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.mesh.dof import place
from vmharness.mesh.nodes import Array

EVERY = -1  # row of what acts on all bodies
SUPPORTS = FORCES


def add(deck: Deck, model: Model) -> None:
    """Add a force for each node of a load, and gravity for each base acceleration."""
    for entry in deck.all(LOAD_NODE_POINT, LOAD_NODE_SET):
        t, value = curve(deck, entry)
        for row in loaded(deck, model.nodes, entry):
            if row in model.owner and not model.owner[row].fixed:
                raise entry.error(
                    None, f"mujoco: a force on node {model.id(row)} of a rigid body is not supported"
                )
            if model.moves(row):
                model.loads.append(Load(row, entry.sf * np.eye(3)[place(entry)], t, value))
    for axis, keyword in enumerate(ALONG):
        for entry in deck.all(keyword):
            _base(deck, model, entry, -entry.sf * np.eye(3)[axis])


def _base(deck: Deck, model: Model, entry: Entry, along: Array) -> None:
    """Gravity, or an acceleration that varies within the run."""
    t, value = curve(deck, entry)
    end = deck.one(CONTROL_TERMINATION).endtim
    within = np.interp([0.0, *t[(t > 0.0) & (t < end)], end], t, value)
    if (within == within[0]).all():
        model.gravity += within[0] * along
    else:
        model.bases.append(Load(EVERY, along, t, value))
