"""*SECTION_BEAM: formulation and cross-section of beams (ELFORM 2) and trusses (ELFORM 3)."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real, skip
from vmharness.deck.keyword import Keyword

SECTION_BEAM = Keyword(
    "SECTION_BEAM",
    Card(
        secid=integer(above=0),
        elform=integer(1, zero_is_default=True, choices=(2, 3)),
        shrf=real(1.0),  # this and the next two serve beams that are integrated over the cross-section
        qr=real(2.0),
        cst=real(0.0),
        scoor=only(0.0),
        nsm=only(0.0),
        naupd=only(0),
    ),
    Card(
        a=real(above=0.0),
        iss=real(above=0.0),
        itt=real(above=0.0),
        j=real(above=0.0),
        sa=real(0.0, at_least=0.0),
        ist=only(0.0),
        itorm=only(0.0),
        sat=only(0.0),
        when=lambda entry: entry.elform == 2,
    ),
    Card(
        a=real(above=0.0),
        rampt=only(0.0),
        stress=only(0.0),
        _4=skip(),
        _5=skip(),
        _6=skip(),
        _7=skip(),
        _8=skip(),
        when=lambda entry: entry.elform == 3,
    ),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
