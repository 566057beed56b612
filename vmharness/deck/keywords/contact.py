"""*CONTACT: three cards that must be there, and optional cards A to G, each after all before it.

Both names of a field are in use: SURFA is SSID, SURFB is MSID; SFSA is SFS, SAST is SST, and so on.
"""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real, skip, text
from vmharness.deck.keyword import Keyword

SEGMENTS = (0, 1, 2, 3, 5, 6)  # kinds of surface that have segments; see surface/choice.py

NODES = (*SEGMENTS, 4)


def contact_keyword(name: str, surfatyp: tuple[int, ...], surfbtyp: tuple[int, ...]) -> Keyword:
    """*`name` with the supported kinds of surface."""
    return Keyword(
        name,
        Card(
            surfa=integer(0),
            surfb=integer(0),
            surfatyp=integer(0, choices=surfatyp),
            surfbtyp=integer(0, choices=surfbtyp),
            saboxid=only(0),
            sbboxid=only(0),
            sapr=integer(0),
            sbpr=integer(0),
        ),
        Card(
            fs=real(0.0, at_least=0.0),
            fd=real(0.0, at_least=0.0),
            dc=real(0.0, at_least=0.0),
            vc=real(0.0, at_least=0.0),
            vdc=real(0.0, at_least=0.0),
            penchk=integer(0, choices=(0,) if "AUTOMATIC" in name else (0, 1, 2)),
            bt=real(0.0, at_least=0.0),
            dt=real(1e20, zero_is_default=True, above=0.0),
        ),
        Card(
            sfsa=real(1.0, zero_is_default=True, above=0.0),
            sfsb=real(1.0, zero_is_default=True, above=0.0),
            sast=real(0.0, at_least=0.0),
            sbst=real(0.0, at_least=0.0),
            sfsat=real(1.0, zero_is_default=True, above=0.0),
            sfsbt=real(1.0, zero_is_default=True, above=0.0),
            fsf=real(1.0, zero_is_default=True, above=0.0),
            vsf=real(1.0, zero_is_default=True, above=0.0),
        ),
        *_optional(),
        options={"ID": Card(cid=integer(0), heading=text("", width=70))},
    )


def _optional() -> tuple[Card, ...]:
    """Cards A to G."""
    a = Card(
        optional=True,
        soft=integer(0, choices=(0, 1)),
        sofscl=real(0.1, zero_is_default=True, above=0.0),
        lcidab=only(0),
        maxpar=only(1.025, zero_is_default=True),
        sbopt=integer(2, zero_is_default=True),
        depth=integer(2, zero_is_default=True),
        bsort=integer(0),
        frcfrq=only(1, zero_is_default=True),
    )
    b = Card(
        optional=True,
        penmax=real(0.0, at_least=0.0),
        thkopt=only(0),
        shlthk=integer(0, choices=(0, 1, 2)),
        snlog=integer(0, choices=(0, 1)),
        isym=only(0),
        i2d3d=only(0),
        sldthk=only(0.0),
        sldstf=only(0.0),
    )
    c = Card(
        optional=True,
        igap=integer(1, zero_is_default=True),
        ignore=integer(0, choices=(0, 1, 2)),
        dprfac=only(0.0),
        dtstif=only(0.0),
        edgek=only(0.0),
        _6=skip(),
        flangl=only(0.0),
        cid_rcf=integer(0),
    )
    d = Card(
        optional=True,
        q2tri=only(0), dtpchk=only(0.0), sfnbr=only(0.0), fnlscl=only(0.0), dnlscl=only(0.0), tcso=only(0),
        tiedid=only(0), shledg=integer(0, choices=(0, 2)),  # edges are round
    )  # fmt: skip
    e = Card(
        optional=True,
        sharec=only(0), cparm8=only(0), ipback=only(0), srnde=only(0), fricsf=only(1.0, zero_is_default=True),
        icor=only(0), ftorq=only(0), region=only(0),
    )  # fmt: skip
    f = Card(
        optional=True,
        pstiff=only(0), ignroff=only(0), _3=skip(), fstol=only(2.0, zero_is_default=True), _2dbinr=only(0),
        ssftyp=only(0), swtpr=only(0), tetfac=only(0.0),
    )  # fmt: skip
    return a, b, c, d, e, f, Card(optional=True, _1=skip(), shloff=only(0.0))


CONTACT_AUTOMATIC_NODES_TO_SURFACE = contact_keyword("CONTACT_AUTOMATIC_NODES_TO_SURFACE", NODES, SEGMENTS)

CONTACT_AUTOMATIC_SINGLE_SURFACE = contact_keyword("CONTACT_AUTOMATIC_SINGLE_SURFACE", SEGMENTS, (0,))

CONTACT_AUTOMATIC_SURFACE_TO_SURFACE = contact_keyword(
    "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", SEGMENTS, SEGMENTS
)

CONTACT_NODES_TO_SURFACE = contact_keyword("CONTACT_NODES_TO_SURFACE", NODES, SEGMENTS)

CONTACT_ONE_WAY_SURFACE_TO_SURFACE = contact_keyword("CONTACT_ONE_WAY_SURFACE_TO_SURFACE", SEGMENTS, SEGMENTS)

CONTACT_SURFACE_TO_SURFACE = contact_keyword("CONTACT_SURFACE_TO_SURFACE", SEGMENTS, SEGMENTS)
