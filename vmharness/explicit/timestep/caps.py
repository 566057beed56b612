"""*CONTROL_TIMESTEP DTINIT and LCTM: no step is longer than these.

    dt_0 <= DTINIT        dt_n <= LC(t_n)

They shorten the step that the elements allow, TSSFAC included, and never lengthen it.
"""

import math

from vmharness.deck import Deck
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.explicit.model.curve import time_curve
from vmharness.explicit.model.model import Model


def build(deck: Deck, model: Model) -> None:
    """Add the caps of the deck to the model."""
    control = deck.first(CONTROL_TIMESTEP)
    if control is None:
        return
    if control.dtinit:
        first = control.dtinit
        model.caps.append(lambda t: first if t == 0.0 else math.inf)
    if control.lctm:
        curve = time_curve(deck, control, "lctm", model.end_time)
        if not (curve.ordinate > 0.0).all():
            raise control.error("lctm", "a largest step that is not positive")
        model.caps.append(curve)
