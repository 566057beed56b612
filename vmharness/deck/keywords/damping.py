"""*DAMPING: damping in proportion to mass, and of parts in proportion to stiffness."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real
from vmharness.deck.keyword import Keyword

FACTORS: dict[str, Field] = {name: real(0.0) for name in ("stx", "sty", "stz", "srx", "sry", "srz")}

DAMPING_GLOBAL = Keyword(
    "DAMPING_GLOBAL",
    Card({"lcid": integer(0), "valdmp": real(0.0), **FACTORS}),
    single=True,
)

DAMPING_PART_MASS = Keyword(
    "DAMPING_PART_MASS",
    Card(
        pid=integer(above=0),
        lcid=integer(),
        sf=real(1.0, zero_is_default=True),
        flag=integer(0),
        struc=integer(0),
    ),
    Card(FACTORS, when=lambda entry: entry.flag == 1),
    repeat=True,
    unique="pid",
    kind="damped part",
)

DAMPING_PART_STIFFNESS = Keyword(
    "DAMPING_PART_STIFFNESS",
    Card(pid=integer(above=0), coef=real(0.0)),
    repeat=True,
    unique="pid",
    kind="part damped by stiffness",
)
