"""Limits of the time step other than the elements' own: caps, springs at nodes of other elements, stiff contacts."""

import math
from collections.abc import Callable

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.explicit.balance import MADE
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.contact.stable_step import longest_step
from vmharness.explicit.elements.discrete.part import Discrete
from vmharness.explicit.force import Elements, Scalable
from vmharness.explicit.model.curve import time_curve
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array

MOST_SHORTER = 100.0  # times: by which a step is shortened for a contact


def add_caps(deck: Deck, model: Model) -> None:
    """Add the caps of *CONTROL_TIMESTEP: dt_0 <= DTINIT, dt_n <= LC(t_n) with the curve LCTM.

    They shorten the step that the elements allow, TSSFAC included, and never lengthen it. Where rigid bodies are all
    that there is, their elements limit the step.
    """
    control = deck.first(CONTROL_TIMESTEP) or Entry.of_defaults(CONTROL_TIMESTEP)
    if not (control.lctm or model.blocks) and math.isfinite(model.rigid_step):
        step = model.step_factor * model.rigid_step
        model.caps.append(lambda t: step)
        model.facts["Step of rigid bodies"] = (
            "nothing else limits the step: L/c of their elements, with E and PR"
        )
    if control.dtinit:
        first = control.dtinit
        model.caps.append(lambda t: first if t == 0.0 else math.inf)
    if control.lctm:
        curve = time_curve(deck, control, "lctm", model.end_time)
        if curve.late:
            raise control.error("lctm", "before OFFA of the curve the largest step would be zero")
        if not (curve.ordinate > 0.0).all():
            raise control.error("lctm", "the largest step must be positive")
        model.caps.append(curve)


def reserve_mass(model: Model) -> None:
    """Set `taken` (n,) of springs and dampers: the sum of m_e/h_e^2 that other elements need at their nodes.

    m_e is the mass (for torsional springs the rotary inertia) that an element gives to a node, h_e its own stable step;
    elements/discrete/limit.py derives the step of springs from this. The sum is a stiffness: it must be taken before
    mass scaling, which raises h_e.
    """
    discrete = [force for force in model.forces if isinstance(force, Discrete)]
    needs = {about: _needed_mass(model, about) for about in {force.about for force in discrete}}
    for force in discrete:
        force.taken = needs[force.about]


def _needed_mass(model: Model, about: bool) -> Array:
    """The sum of m_e/h_e^2 (n,), or of rotary inertia instead of mass if `about` an axis."""
    need = np.zeros(model.ids.size)
    for block in model.forces:
        if isinstance(block, Scalable):
            share = (block.inertia if about else block.mass) / block.steps(model.state.x) ** 2
            for corner in block.nodes.T:
                np.add.at(need, corner, share)
    return need


def report_contact_steps(deck: Deck, model: Model) -> None:
    """Shorten the step for each contact that elements and caps would let be unstable, and add a fact.

    LS-DYNA does not: such a contact makes energy from nothing. The step becomes that with which impacts keep their
    energy to MADE, unless that is less than 1/MOST_SHORTER of it, as for a node almost without mass.
    """
    step = _first_step(deck, model)
    held = np.zeros(model.ids.size, bool)
    for constraint in model.constraints:
        held |= constraint.fixed[:, :3].all(axis=1)
    for contact in model.forces:
        if isinstance(contact, Contact) and contact.options.soft == 0:
            longest = min(longest_step(one, model.state.mass, held) for one in contact.passes)
            if longest < step:
                enough = MADE**0.5 * longest
                if step <= MOST_SHORTER * enough:
                    model.caps.append(constant(enough))
                model.facts[f"Step of {contact.name}"] = (
                    f"should not exceed {enough:.4g}, with which impacts keep their energy to {100.0 * MADE:g} %; the "
                    f"contact is stable up to {longest:.4g}; "
                    + (
                        f"the step is shortened from {step:.4g}"
                        if step <= MOST_SHORTER * enough
                        else f"the step may begin with {step:.4g}, which is too much to shorten"
                    )
                )


def constant(step: float) -> Callable[[float], float]:
    """A cap that does not change."""
    return lambda t: step


def _first_step(deck: Deck, model: Model) -> float:
    """The step that elements with mass and caps allow; zero if only springs limit it, or nothing does."""
    control = deck.first(CONTROL_TIMESTEP)
    scaled = abs(control.dt2ms) if control else 0.0
    elements = [block for block in model.forces if isinstance(block, Elements)]
    steps = [block.steps(model.state.x).min() for block in elements if isinstance(block, Scalable)]
    if elements and not steps:
        return 0.0
    allowed = [model.step_factor * max(min(steps), scaled)] if steps else []
    soon = math.nextafter(0.0, 1.0)  # just after t = 0, where DTINIT no longer acts
    return min([*allowed, *[cap(soon) for cap in model.caps]], default=0.0)
