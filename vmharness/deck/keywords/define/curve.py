"""*DEFINE_CURVE: ordinates over abscissae."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck.card import Card, Rows
from vmharness.deck.entry import Entry
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

DEFINE_CURVE = Keyword(
    "DEFINE_CURVE",
    Card(
        lcid=integer(above=0),
        sidr=integer(0),
        sfa=real(1.0, zero_is_default=True),
        sfo=real(1.0, zero_is_default=True),
        offa=real(0.0),
        offo=real(0.0),
        dattyp=integer(0),
        lcint=integer(0),  # points of LS-DYNA's own resampling
    ),
    Rows(a1=real(0.0, width=20), o1=real(0.0, width=20)),
    options=("TITLE",),
    unique="lcid",
    kind="curve",
)


def points(curve: Entry) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Abscissae SFA (A + OFFA) and ordinates SFO (O + OFFO), each (n,).

    Raises DeckError unless the abscissae increase.
    """
    abscissa = curve.sfa * (curve.a1 + curve.offa)
    backward = np.flatnonzero(np.diff(abscissa) <= 0.0)
    if backward.size:
        raise curve.error("a1", "abscissae must increase from point to point", int(backward[0]) + 1)
    return abscissa, curve.sfo * (curve.o1 + curve.offo)
