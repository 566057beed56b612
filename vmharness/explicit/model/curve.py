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

JUMP = (
    1e-9  # half the width of the jump at a late beginning, relative to its time; above the round-off of times
)


class Curve:
    """Ordinate over abscissa, linear between points; constant where there is one point only.

    With `late` the curve begins after t = 0: it is zero before its first point. At that point, where it may jump, it
    has half the first ordinate, so that the impulse of a load has an error of second order in the step.
    """

    def __init__(self, abscissa: Array, ordinate: Array, late: bool = False) -> None:
        if late:
            first = abscissa[0]
            before, after = first * (1.0 - JUMP), first * (1.0 + JUMP)
            abscissa = np.concatenate([[0.0, before, after], abscissa[1:]])
            ordinate = np.concatenate([[0.0, 0.0], ordinate])
        self.abscissa, self.ordinate, self.late = abscissa, ordinate, late
        self.constant = bool(np.all(ordinate == ordinate[0]))

    def __call__(self, t: float) -> float:
        """The ordinate at t."""
        if self.constant:  # most curves are; constant gravity then costs nothing per cycle
            return float(self.ordinate[0])
        return float(np.interp(t, self.abscissa, self.ordinate))

    @property
    def first(self) -> float:
        """The ordinate at the beginning of the curve."""
        return float(self.ordinate[2]) if self.late else self(0.0)

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

    Before a positive offset OFFA the curve is zero, as in LS-DYNA. What LS-DYNA does beyond the last point is not
    established, so a curve must last to the end time, and begin at 0 unless OFFA moves it to a later time.
    """
    definition = deck.find(DEFINE_CURVE, lcid=getattr(entry, field), referred_by=(entry, field))
    abscissa, ordinate = points(definition)
    late = bool(abscissa[0] > 0.0 and definition.offa > 0.0 and definition.a1[0] <= 0.0)
    if (abscissa[0] > 0.0 and not late) or abscissa[-1] < end_time:
        raise entry.error(
            field,
            f"the curve spans {abscissa[0]:g} to {abscissa[-1]:g}, but the run 0 to {end_time:g}; "
            "extend it, since what happens outside a curve is not defined",
        )
    return Curve(abscissa, ordinate, late)
