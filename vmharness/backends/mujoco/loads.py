"""Nodal forces and accelerations of the base, by curves.

A base acceleration that is constant is the gravity of the model, with the opposite sign; one that varies acts as the
force -m SF LC(t) at the centre of each body. Curves are evaluated at the stages of the Runge-Kutta method.
"""

import numpy as np

from vmharness.backends.mujoco.model import Load, Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.load.body import LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z
from vmharness.deck.keywords.load.node import LOAD_NODE_POINT, LOAD_NODE_SET
from vmharness.deck.rule import among, no_effect, only
from vmharness.deck.support import supports
from vmharness.mesh.dof import place
from vmharness.mesh.nodes import Array
from vmharness.mesh.sets import node_set

LOAD = {"dof": among(1, 2, 3), "cid": only(0), **{f"m{i}": only(0) for i in (1, 2, 3)}}
ALONG = (LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z)
EVERY = -1  # row of what acts on all bodies
SUPPORTS = (
    *(supports(keyword, **LOAD) for keyword in (LOAD_NODE_POINT, LOAD_NODE_SET)),
    *(supports(keyword, cid=only(0), lciddr=no_effect("of dynamic relaxation")) for keyword in ALONG),
)


def add(deck: Deck, model: Model) -> None:
    """Add a force for each node of a load, and gravity for each base acceleration."""
    for entry in deck.all(LOAD_NODE_POINT, LOAD_NODE_SET):
        point = entry.keyword is LOAD_NODE_POINT
        rows = [model.nodes.row(entry, "nid", entry.nid)] if point else _set(deck, model, entry)
        t, value = _curve(deck, entry)
        for row in rows:
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
    t, value = _curve(deck, entry)
    end = deck.one(CONTROL_TERMINATION).endtim
    within = np.interp([0.0, *t[(t > 0.0) & (t < end)], end], t, value)
    if (within == within[0]).all():
        model.gravity += within[0] * along
    else:
        model.bases.append(Load(EVERY, along, t, value))


def _set(deck: Deck, model: Model, entry: Entry) -> list[int]:
    return [int(row) for row in node_set(deck, model.nodes, entry, "nsid")]


def _curve(deck: Deck, entry: Entry) -> tuple[Array, Array]:
    return points(deck.find(DEFINE_CURVE, lcid=entry.lcid, referred_by=(entry, "lcid")))
