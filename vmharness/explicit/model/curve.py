"""Time curves of *DEFINE_CURVE for loads."""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.define.curve import DEFINE_CURVE, points
from vmharness.deck.rule import no_effect, only
from vmharness.deck.support import supports
from vmharness.explicit.state import Array

SUPPORTS = (
    supports(DEFINE_CURVE, sidr=only(0), dattyp=only(0), lcint=no_effect("curves are used as they are")),
)


class Curve:
    """Ordinate over abscissa, linear between points; constant where there is one point only."""

    def __init__(self, abscissa: Array, ordinate: Array) -> None:
        self.abscissa, self.ordinate = abscissa, ordinate
        self.constant = bool(np.all(ordinate == ordinate[0]))

    def __call__(self, t: float) -> float:
        """The ordinate at t."""
        if self.constant:  # most curves are; constant gravity then costs nothing per cycle
            return float(self.ordinate[0])
        return float(np.interp(t, self.abscissa, self.ordinate))

    def mean(self, start: float, end: float) -> float:
        """The mean ordinate from `start` to `end`; exact, also with points between them."""
        if self.constant:
            return float(self.ordinate[0])
        inside = self.abscissa[(self.abscissa > start) & (self.abscissa < end)]
        t = np.array([start, *inside, end])
        return float(np.trapezoid(np.interp(t, self.abscissa, self.ordinate), t) / (end - start))

    def rate(self, start: float, end: float) -> float:
        """The mean slope from `start` to `end`, or to the last point, which a run passes by a part of a step."""
        end = min(end, float(self.abscissa[-1]))
        return (self(end) - self(start)) / (end - start)

    def largest(self) -> float:
        """The ordinate of largest magnitude, the first of equal ones."""
        return float(self.ordinate[np.argmax(np.abs(self.ordinate))])

    def slope(self) -> float:
        """The slope of the first segment."""
        return 0.0 if self.constant else self.rate(float(self.abscissa[0]), float(self.abscissa[1]))


def time_curve(deck: Deck, entry: Entry, field: str, end_time: float) -> Curve:
    """The curve that `field` of `entry` names; raises DeckError when it does not span the run.

    What LS-DYNA does beyond the last point is not established, so a curve must cover 0 to the end time.
    """
    definition = deck.find(DEFINE_CURVE, lcid=getattr(entry, field), referred_by=(entry, field))
    abscissa, ordinate = points(definition)
    if abscissa[0] > 0.0 or abscissa[-1] < end_time:
        raise entry.error(
            field,
            f"the curve spans {abscissa[0]:g} to {abscissa[-1]:g}, but the run 0 to {end_time:g}; "
            "extend it, since what happens outside a curve is not defined",
        )
    return Curve(abscissa, ordinate)
