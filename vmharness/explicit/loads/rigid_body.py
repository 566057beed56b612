"""*LOAD_RIGID_BODY: a force at the centre of a rigid body, or a moment, SF LC(t), along a global axis."""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.load.rigid_body import LOAD_RIGID_BODY
from vmharness.explicit.loads.node import NodalLoad
from vmharness.explicit.model.curve import time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.numbers import lead_number
from vmharness.mesh.dof import place

NAME = "load on a rigid body"


def build(deck: Deck, model: Model) -> None:
    """Add a force for each card: to the loop, the centre of a body is a node."""
    for entry in deck.all(LOAD_RIGID_BODY):
        model.forces.append(_load(deck, model, entry))


def _load(deck: Deck, model: Model, entry: Entry) -> NodalLoad:
    number = lead_number(deck, entry, "pid")
    return NodalLoad(
        name=f"load on rigid body {number}",
        nodes=np.array([model.centre(number)], np.intp),
        dofs=np.array([place(entry)]),
        scale=np.array([entry.sf]),
        curve=time_curve(deck, entry, "lcid", model.end_time),
    )
