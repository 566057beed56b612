"""A characteristic: force over elongation, or over its rate, as a curve of the deck.

Beyond its ends it has the slope of its last segment, as LS-DYNA extrapolates curves of materials.
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.state import Array

Characteristic = tuple[Array, Array]  # abscissae (m,), increasing, and ordinates (m,)


def characteristic(deck: Deck, entry: Entry, field: str) -> Characteristic:
    """The curve that `field` of `entry` names.

    Raises DeckError unless it passes through (0, 0) with points on both sides.
    """
    definition = deck.find(DEFINE_CURVE, lcid=getattr(entry, field), referred_by=(entry, field))
    abscissa, ordinate = points(definition)
    if not (abscissa[0] < 0.0 < abscissa[-1] and np.interp(0.0, abscissa, ordinate) == 0.0):
        raise entry.error(field, "the curve must pass through (0, 0), with points on both sides of it")
    return abscissa, ordinate


def steepest(curve: Characteristic) -> float:
    """The largest slope of any segment; 0 where the curve falls everywhere."""
    return max(0.0, float(np.max(np.diff(curve[1]) / np.diff(curve[0]))))


@inlined
def ordinate(curve: Characteristic, x: float) -> float:
    """y_i + (y_{i+1} - y_i)/(x_{i+1} - x_i) (x - x_i) in the segment i of x, or the nearest one."""
    abscissa, values = curve
    i, last = 0, abscissa.size - 1
    while last - i > 1:
        middle = (i + last) // 2
        if x < abscissa[middle]:
            last = middle
        else:
            i = middle
    slope = (values[i + 1] - values[i]) / (abscissa[i + 1] - abscissa[i])
    return float(values[i] + slope * (x - abscissa[i]))
