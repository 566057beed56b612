"""*DAMPING_PART_STIFFNESS: damping in proportion to stiffness.

The damping adds to the stress s of the law beta times its rate, in the element's own frame, so that rigid motions are
not damped:

    tau_n = s_n + beta (s_n - s_{n-1}) / dt        zeta = beta omega / 2 for a mode of frequency omega

In beams of resultants, these take the place of stress. Forces are those of tau, which is also the stress of probes. Its
work is internal energy, stored and dissipated, as that of bulk viscosity is: the internal energy therefore does not
return to zero. Hourglass and viscous forces, which are not part of the law, are not damped. During plastic flow only
the part of the strain rate that changes the stress is damped.

    COEF < 0   beta = -COEF, a time
    COEF > 0   beta = COEF 2/omega_max, with 2/omega_max the element's stable step in the beginning: COEF is the
               fraction of critical damping of the element's highest mode. LS-DYNA does not publish its formula for
               this, so that this is our definition; 0.01 to 0.25 is what it recommends.

The rate is that half a step earlier. Therefore the motion is accurate to the first order in dt, and the stable step h
of the undamped element becomes shorter (M - dt/2 C - dt^2/4 K must be positive definite):

    dt <= h (sqrt(1 + zeta^2) - zeta),   zeta = beta/h

Source: LS-DYNA keyword manual, the card; R. W. Clough, J. Penzien, Dynamics of Structures, Rayleigh damping.
"""

from math import hypot

import numpy as np

from vmharness.deck import Deck
from vmharness.deck.keywords.damping import DAMPING_PART_STIFFNESS
from vmharness.deck.keywords.part import PART
from vmharness.deck.support import supports
from vmharness.explicit.force import Dampable, Elements
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array

SUPPORTS = (supports(DAMPING_PART_STIFFNESS),)


def build(deck: Deck, model: Model) -> None:
    """Damp the elements of each part, and limit the step; raises DeckError for elements that cannot be damped."""
    for entry in deck.all(DAMPING_PART_STIFFNESS):
        deck.find(PART, pid=entry.pid, referred_by=(entry, "pid"))
        blocks = [item for item in model.forces if isinstance(item, Elements) and item.pid == entry.pid]
        if not blocks:
            raise entry.error("pid", "the part has no deformable elements: there is nothing to damp")
        for block in blocks:
            if not isinstance(block, Dampable):
                raise entry.error("pid", f"damping of {block.name} by stiffness is not supported")
            if entry.coef:
                steps = block.steps(model.state.x)
                beta = entry.coef * steps if entry.coef > 0.0 else np.full_like(steps, -entry.coef)
                damp_elements(model, block, beta)


def damp_elements(model: Model, block: Dampable, beta: Array) -> None:
    """Damp elements with `beta` (ne,), a time, and limit the step to what is stable with this damping."""
    block.damp(beta)

    def longest(t: float) -> float:
        zeta = float(np.max(beta / block.steps(model.state.x)))
        return model.step_factor * damped_step(block.stable_step(), zeta)

    model.caps.append(longest)


def damped_step(step: float, zeta: float) -> float:
    """The stable step with the fraction `zeta` of critical damping, the rate being half a step old.

    >>> damped_step(2.0, 0.75)
    1.0
    """
    return step * (hypot(1.0, zeta) - zeta)
