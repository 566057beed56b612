"""*ELEMENT_MASS as MASS elements."""

import numpy as np

from vmharness.backends.calculix.model import Lines, Model, real
from vmharness.deck import Deck
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.element.mass import ELEMENT_MASS
from vmharness.deck.support import supports

SUPPORTS = (supports(ELEMENT_MASS),)
SOFT = 1e-10  # (omega T)^2 of the springs of free masses, T the time of the run: far below the digits of the output


def add(deck: Deck, model: Model) -> None:
    """Add the masses to their nodes."""
    for entry in deck.all(ELEMENT_MASS):
        rows = model.nodes.find(entry, "nid", entry.nid)
        for eid, row, mass in zip(entry.eid.tolist(), rows.tolist(), entry.mass.tolist(), strict=True):
            model.add(entry.keyword, eid, "MASS", f"MASS{eid}", [row])
            model.elements += [f"*MASS,ELSET=MASS{eid}", real(mass)]
            model.mass[row] += mass
            model.lumped[row] += mass


def free(model: Model) -> list[int]:
    """Rows of the masses that no element holds."""
    return np.flatnonzero((model.lumped > 0.0) & (model.stiff == 0.0)).tolist()


def anchors(model: Model) -> Lines:
    """Springs to the ground, too soft to act, for free masses: CalculiX moves no node that has a MASS alone.

    Without them such a node keeps its initial velocity under any load, CLOAD or GRAV, and ccx reports no error.
    """
    end = model.deck.one(CONTROL_TERMINATION).endtim
    lines: Lines = []
    for row in free(model):
        for dof in (1, 2, 3):
            model.count += 1
            name = f"ANCHOR{model.count}"
            stiffness = real(SOFT * float(model.lumped[row]) / end**2)
            lines += [f"*ELEMENT,TYPE=SPRING1,ELSET={name}", f"{model.count},{row + 1}"]
            lines += [f"*SPRING,ELSET={name}", str(dof), stiffness]
    return lines
