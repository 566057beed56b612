"""*CONTROL_SOLID: options of all solids."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CONTROL_SOLID = Keyword(
    "CONTROL_SOLID",
    Card(
        esort=integer(0),  # 1 makes wedges and tetrahedra of degenerate hexahedra
        fmatrx=integer(0),
        niptets=integer(4, zero_is_default=True),
        swlocl=integer(1, zero_is_default=True),
        psfail=integer(0),
        t10jtol=real(0.0),
        icoh=integer(0),
        tet13k=integer(0),
    ),
    Card({f"pm{i}": integer(0, width=8) for i in range(1, 11)}, optional=True),
    Card(optional=True, tet13v=integer(0), rinrt=integer(0), coheqc=integer(0)),
    single=True,
)
