"""*SECTION_SHELL: formulation, integration points and thickness of shells."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real
from vmharness.deck.keyword import Keyword

SECTION_SHELL = Keyword(
    "SECTION_SHELL",
    Card(
        secid=integer(above=0),
        elform=integer(2, zero_is_default=True),
        shrf=real(1.0, zero_is_default=True, above=0.0),
        nip=integer(2, zero_is_default=True, above=0),
        propt=real(1.0, choices=(0.0, 1.0, 2.0, 3.0)),  # what is printed
        qr=only(0.0),
        icomp=only(0),
        setyp=only(1, zero_is_default=True),
    ),
    Card(
        t1=real(0.0, at_least=0.0),
        t2=real(0.0, at_least=0.0),
        t3=real(0.0, at_least=0.0),
        t4=real(0.0, at_least=0.0),
        nloc=only(0.0),
        marea=only(0.0),
        idof=only(0.0),
        edgset=only(0),
    ),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
