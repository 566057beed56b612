"""The deck's *DAMPING_PART_STIFFNESS -> damped elements, and the step that they need."""

from math import hypot

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.damping import DAMPING_PART_STIFFNESS
from vmharness.deck.keywords.part import PART
from vmharness.explicit.force import Dampable, Elements
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array


def build(deck: Deck, model: Model) -> None:
    """Damp the elements of each part, and cap the step; raises DeckError at parts that cannot be damped."""
    for entry in deck.all(DAMPING_PART_STIFFNESS):
        deck.find(PART, pid=entry.pid, referred_by=(entry, "pid"))
        for block in [
            force for force in model.forces if isinstance(force, Elements) and force.pid == entry.pid
        ]:
            if not isinstance(block, Dampable):
                raise entry.error("pid", f"damping of {block.name} by stiffness is not supported")
            if entry.coef:
                steps = block.steps(model.state.x)
                damp(
                    model, block, entry.coef * steps if entry.coef > 0.0 else np.full_like(steps, -entry.coef)
                )


def damp(model: Model, block: Dampable, beta: Array) -> None:
    """Damp a block with `beta` (ne,), a time, and let no step be longer than it then may be."""
    block.damp(beta)

    def longest(t: float) -> float:
        zeta = float(np.max(beta / block.steps(model.state.x)))
        return model.step_factor * shortened(block.stable_step(), zeta)

    model.caps.append(longest)


def shortened(step: float, zeta: float) -> float:
    """The stable step with the fraction `zeta` of critical damping, half a step old.

    >>> shortened(2.0, 0.75)
    1.0
    """
    return step * (hypot(1.0, zeta) - zeta)
