"""*DAMPING_PART_MASS and _STIFFNESS: f = -D m v at the masses of a part, and f = beta k dl/dt of its trusses."""

import numpy as np

from vmharness.backends.mujoco.model import Model
from vmharness.deck import Deck
from vmharness.deck.keywords.damping import DAMPING_PART_MASS, DAMPING_PART_STIFFNESS
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import Rule, only
from vmharness.deck.support import supports
from vmharness.mesh.sets import nodes_of_parts

TIME = "only a negative coefficient, beta itself, is supported"
SUPPORTS = (
    supports(DAMPING_PART_MASS, flag=only(0), struc=only(0)),
    supports(DAMPING_PART_STIFFNESS, coef=Rule(lambda coef: np.less_equal(coef, 0.0), TIME, "negative")),
)


def add(deck: Deck, model: Model) -> None:
    """Note D of the nodes of damped parts; raises DeckError if it varies, or differs between parts at one node."""
    for entry in deck.all(DAMPING_PART_MASS):
        deck.find(PART, pid=entry.pid, referred_by=(entry, "pid"))
        curve = deck.find(DEFINE_CURVE, lcid=entry.lcid, referred_by=(entry, "lcid"))
        value = entry.sf * points(curve)[1]
        if (value != value[0]).any():
            raise entry.error("lcid", "mujoco: damping that varies is not supported")
        rows = nodes_of_parts(deck, model.nodes, {entry.pid})
        others = nodes_of_parts(deck, model.nodes, {part.pid for part in deck.all(PART)} - {entry.pid})
        for row in rows.tolist():
            if row in model.owner or row in others:
                what = (
                    f"mujoco: node {model.id(row)} belongs to another part, or to a rigid one; not supported"
                )
                raise entry.error("pid", what)
        model.drag[rows] = value[0]


def stiffness_time(deck: Deck, pid: int) -> float:
    """beta of a part, zero where it has none."""
    return next((-entry.coef for entry in deck.all(DAMPING_PART_STIFFNESS) if entry.pid == pid), 0.0)
