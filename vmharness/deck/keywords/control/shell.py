"""*CONTROL_SHELL: options of all shells: ISTUPD, whether their thickness follows the strain through it."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

CONTROL_SHELL = Keyword(
    "CONTROL_SHELL",
    Card(
        wrpang=real(20.0),  # angle of a warning
        esort=integer(0, choices=(0, 1)),  # 1 makes C0 triangles of degenerate shells, as is done here always
        irnxx=integer(-1, choices=(-2, -1, 0)),  # fibre directions, which ELFORM 2 has none of
        istupd=integer(0, choices=(0, 1)),
        theory=only(2, zero_is_default=True),
        bwc=only(2, zero_is_default=True),
        miter=only(1, zero_is_default=True),
        proj=only(0),
    ),
    single=True,
)
