"""*SECTION_BEAM: formulation and cross-section of beams and trusses; ELFORM says which second card there is."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real, skip
from vmharness.deck.keyword import Keyword

RESULTANT, TRUSS, DISCRETE = (2, 12, 13), (3,), (6,)  # ELFORM; others are integrated over the cross-section
SPOT_WELD = 9

SIDES: dict[str, Field] = {name: real(0.0) for name in ("ts1", "ts2", "tt1", "tt2")}


SECTION_BEAM = Keyword(
    "SECTION_BEAM",
    Card(
        secid=integer(above=0),
        elform=integer(1, zero_is_default=True),
        shrf=real(1.0),
        qr=real(2.0),
        cst=real(0.0),
        scoor=real(0.0),
        nsm=real(0.0),
        naupd=integer(0),
    ),
    Card(
        a=real(),
        iss=real(),
        itt=real(),
        j=real(),
        sa=real(0.0),
        ist=real(0.0),
        itorm=real(0.0),
        sat=real(0.0),
        when=lambda entry: entry.elform in RESULTANT,
    ),
    Card(
        a=real(),
        rampt=real(0.0),
        stress=real(0.0),
        _4=skip(),
        _5=skip(),
        _6=skip(),
        _7=skip(),
        _8=skip(),
        when=lambda entry: entry.elform in TRUSS,
    ),
    Card(
        vol=real(0.0),
        iner=real(0.0),
        cid=integer(0),
        ca=real(0.0),
        offset=real(0.0),
        rrcon=real(0.0),
        srcon=real(0.0),
        trcon=real(0.0),
        when=lambda entry: entry.elform in DISCRETE,
    ),
    Card(
        SIDES,
        print=real(0.0),
        _6=skip(),
        itoff=real(0.0),
        when=lambda entry: entry.elform == SPOT_WELD,
    ),
    Card(
        SIDES,
        nsloc=real(0.0),
        ntloc=real(0.0),
        itorm=real(0.0),
        when=lambda entry: entry.elform not in (*RESULTANT, *TRUSS, *DISCRETE, SPOT_WELD),
    ),
    repeat=True,
    options=("TITLE",),
    unique="secid",
    kind="section",
)
