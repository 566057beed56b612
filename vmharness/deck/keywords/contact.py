"""*CONTACT: three cards that must be there, and optional cards A to G, each after all before it.

The options _ID and _TITLE put the same card before them. Both names of a field are in use: SURFA is SSID, SURFB is
MSID; SFSA is SFS, SAST is SST, and so on.
"""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, skip, text
from vmharness.deck.keyword import Keyword

NUMBER = Card(cid=integer(0), heading=text("", width=70))


def contact_keyword(name: str) -> Keyword:
    """The cards of a contact, which are those of all kinds that have no cards of their own."""
    return Keyword(
        name,
        Card(
            surfa=integer(0),
            surfb=integer(0),
            surfatyp=integer(0),
            surfbtyp=integer(0),
            saboxid=integer(0),
            sbboxid=integer(0),
            sapr=integer(0),
            sbpr=integer(0),
        ),
        Card(
            fs=real(0.0),
            fd=real(0.0),
            dc=real(0.0),
            vc=real(0.0),
            vdc=real(0.0),
            penchk=integer(0),
            bt=real(0.0),
            dt=real(1e20, zero_is_default=True),
        ),
        Card(
            sfsa=real(1.0, zero_is_default=True),
            sfsb=real(1.0, zero_is_default=True),
            sast=real(0.0),
            sbst=real(0.0),
            sfsat=real(1.0, zero_is_default=True),
            sfsbt=real(1.0, zero_is_default=True),
            fsf=real(1.0, zero_is_default=True),
            vsf=real(1.0, zero_is_default=True),
        ),
        *_optional(),
        options={"ID": NUMBER, "TITLE": NUMBER},
    )


def _optional() -> tuple[Card, ...]:
    """Cards A to G."""
    a = Card(
        optional=True,
        soft=integer(0),
        sofscl=real(0.1, zero_is_default=True),
        lcidab=integer(0),
        maxpar=real(1.025, zero_is_default=True),
        sbopt=integer(2, zero_is_default=True),
        depth=integer(2, zero_is_default=True),
        bsort=integer(0),
        frcfrq=integer(1, zero_is_default=True),
    )
    b = Card(
        optional=True,
        penmax=real(0.0),
        thkopt=integer(0),
        shlthk=integer(0),
        snlog=integer(0),
        isym=integer(0),
        i2d3d=integer(0),
        sldthk=real(0.0),
        sldstf=real(0.0),
    )
    c = Card(
        optional=True,
        igap=integer(1, zero_is_default=True),
        ignore=integer(0),
        dprfac=real(0.0),
        dtstif=real(0.0),
        edgek=real(0.0),
        _6=skip(),
        flangl=real(0.0),
        cid_rcf=integer(0),
    )
    d = Card(
        optional=True,
        q2tri=integer(0),
        dtpchk=real(0.0),
        sfnbr=real(0.0),
        fnlscl=real(0.0),
        dnlscl=real(0.0),
        tcso=integer(0),
        tiedid=integer(0),
        shledg=integer(0),
    )
    e = Card(
        optional=True,
        sharec=integer(0),
        cparm8=integer(0),
        ipback=integer(0),
        srnde=integer(0),
        fricsf=real(1.0, zero_is_default=True),
        icor=integer(0),
        ftorq=integer(0),
        region=integer(0),
    )
    f = Card(
        optional=True,
        pstiff=integer(0),
        ignroff=integer(0),
        _3=skip(),
        fstol=real(2.0, zero_is_default=True),
        binr2d=integer(0),  # 2DBINR
        ssftyp=integer(0),
        swtpr=integer(0),
        tetfac=real(0.0),
    )
    return a, b, c, d, e, f, Card(optional=True, _1=skip(), shloff=real(0.0))


CONTACT_AUTOMATIC_NODES_TO_SURFACE = contact_keyword("CONTACT_AUTOMATIC_NODES_TO_SURFACE")
CONTACT_AUTOMATIC_SINGLE_SURFACE = contact_keyword("CONTACT_AUTOMATIC_SINGLE_SURFACE")
CONTACT_AUTOMATIC_SURFACE_TO_SURFACE = contact_keyword("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE")
CONTACT_NODES_TO_SURFACE = contact_keyword("CONTACT_NODES_TO_SURFACE")
CONTACT_ONE_WAY_SURFACE_TO_SURFACE = contact_keyword("CONTACT_ONE_WAY_SURFACE_TO_SURFACE")
CONTACT_SURFACE_TO_SURFACE = contact_keyword("CONTACT_SURFACE_TO_SURFACE")
