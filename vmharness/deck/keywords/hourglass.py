"""*HOURGLASS: hourglass control of the parts that refer to it."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

HOURGLASS = Keyword(
    "HOURGLASS",
    Card(
        hgid=integer(above=0),
        ihq=integer(0),
        qm=real(0.1, zero_is_default=True),
        ibq=integer(0),
        q1=real(1.5),
        q2=real(0.06),
        qb=real(0.1, zero_is_default=True),
        qw=real(0.1, zero_is_default=True),
    ),
    repeat=True,
    options=("TITLE",),
    unique="hgid",
    kind="hourglass control",
)
