"""Reactions of supports."""

from typing import Literal

import numpy as np

from vmharness.explicit.constraints.spc import Supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.probe import Probe, ProbeError, of_resultant

KEYS = ("support",)


def probe(model: Model, support: int | Literal["all"], component: str) -> Probe:
    """A component of the sum of all reactions of supports, or of those at one node: `z-force`, `x-moment`."""
    supports = [item for item in model.constraints if isinstance(item, Supports)]
    if not supports:
        raise ProbeError("no support in the deck")
    # One constraint holds all supports of a deck.
    if support == "all":
        return of_resultant(supports[0].total, component, "of a support")
    rows = np.flatnonzero(model.ids == support)
    if not rows.size or not supports[0].fixed[rows[0]].any():
        raise ProbeError(f"no support at node {support}")
    return of_resultant(supports[0].reaction[rows[0]], component, "of a support")
