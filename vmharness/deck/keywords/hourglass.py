"""*HOURGLASS: hourglass control of the parts that refer to it."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

HOURGLASS = Keyword(
    "HOURGLASS",
    Card(
        hgid=integer(above=0),
        ihq=integer(0, choices=tuple(range(7))),
        qm=real(0.1, zero_is_default=True, at_least=0.0),
        ibq=only(0),
        q1=real(1.5, at_least=0.0),
        q2=real(0.06, at_least=0.0),
        qb=real(0.1, zero_is_default=True, at_least=0.0),
        qw=real(0.1, zero_is_default=True, at_least=0.0),
    ),
    repeat=True,
    options=("TITLE",),
    unique="hgid",
    kind="hourglass control",
)
