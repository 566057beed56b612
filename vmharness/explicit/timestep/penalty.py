"""Contacts that are stiffer than the time step allows are told as a fact; the step is left as it is."""

import math

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.stable_step import longest_step
from vmharness.explicit.force import Elements, Scalable
from vmharness.explicit.model.model import Model


def build(deck: Deck, model: Model) -> None:
    """Add a fact for each contact whose own step is shorter than that which shells, solids and caps allow."""
    step = _step(deck, model)
    held = np.zeros(model.ids.size, bool)
    for constraint in model.constraints:
        held |= constraint.fixed[:, :3].all(axis=1)
    for contact in model.forces:
        if isinstance(contact, Contact) and contact.options.soft == 0:
            longest = min(longest_step(one, model.state.mass, held) for one in contact.passes)
            if longest < step:
                model.facts[f"Step of {contact.name}"] = (
                    f"should not exceed {longest:.4g} for the stiffness of the contact; it may begin with {step:.4g}"
                )


def _step(deck: Deck, model: Model) -> float:
    """The step that shells, solids and caps allow; zero where springs alone know it, or nothing does."""
    control = deck.first(CONTROL_TIMESTEP)
    scaled = abs(control.dt2ms) if control else 0.0
    elements = [block for block in model.forces if isinstance(block, Elements)]
    steps = [block.steps(model.state.x).min() for block in elements if isinstance(block, Scalable)]
    if elements and not steps:
        return 0.0
    allowed = [model.step_factor * max(min(steps), scaled)] if steps else []
    soon = math.nextafter(0.0, 1.0)  # DTINIT rules at 0 alone
    return min([*allowed, *[cap(soon) for cap in model.caps]], default=0.0)
