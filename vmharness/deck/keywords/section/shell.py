"""*SECTION_SHELL: formulation, integration points and thickness of shells."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

LAYERS = 200  # integration points through the thickness, at most


def _angles(first: int) -> Card:
    """Material angles of eight integration points, with ICOMP = 1."""
    return Card(
        {f"b{i}": real(0.0) for i in range(first, first + 8)},
        when=lambda entry: entry.icomp == 1 and entry.nip >= first,
    )


SECTION_SHELL = Keyword(
    "SECTION_SHELL",
    Card(
        secid=integer(above=0),
        elform=integer(2, zero_is_default=True),
        shrf=real(1.0, zero_is_default=True),
        nip=integer(2, zero_is_default=True),
        propt=real(1.0),  # what is printed
        qr=real(0.0),
        icomp=integer(0),
        setyp=integer(1, zero_is_default=True),
    ),
    Card(
        t1=real(0.0),
        t2=real(0.0),
        t3=real(0.0),
        t4=real(0.0),
        nloc=real(0.0),
        marea=real(0.0),
        idof=real(0.0),
        edgset=integer(0),
    ),
    *(_angles(first) for first in range(1, LAYERS, 8)),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
