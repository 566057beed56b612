"""*DATABASE_...: what LS-DYNA writes, and how often."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword

ASCII = tuple(
    Keyword(
        f"DATABASE_{name}",
        Card(
            dt=real(0.0),
            binary=integer(0),
            lcur=integer(0),
            ioopt=integer(1),
            option1=real(0.0),
            option2=integer(0),
            option3=integer(0),
            option4=integer(0),
        ),
    )
    for name in (
        "BNDOUT",
        "DEFORC",
        "ELOUT",
        "GLSTAT",
        "JNTFORC",
        "MATSUM",
        "NCFORC",
        "NODFOR",
        "NODOUT",
        "RBDOUT",
        "RCFORC",
        "RWFORC",
        "SECFORC",
        "SLEOUT",
        "SPCFORC",
        "SSSTAT",
        "TPRINT",
    )
)

BINARY = tuple(
    Keyword(
        f"DATABASE_BINARY_{name}",
        Card(
            dt=real(0.0),
            lcdt=integer(0),
            beam=integer(0),
            npltc=integer(0),
            psetid=integer(0),
        ),
        Card(
            optional=True,
            ioopt=integer(0),
            rate=real(0.0),
            cutoff=real(0.0),
            window=real(0.0),
            type=integer(0),
            pset=integer(0),
        ),
    )
    for name in ("D3DUMP", "D3PART", "D3PLOT", "D3THDT", "INTFOR", "RUNRSF")
)

BINARY_D3PROP = Keyword("DATABASE_BINARY_D3PROP", Card(ifile=integer(1), imatl=integer(0), iwall=integer(0)))

FORMAT = Keyword("DATABASE_FORMAT", Card(iform=integer(0), ibinary=integer(0)))

ENTITIES = ("BEAM", "DISCRETE", "NODE", "SHELL", "SOLID")

HISTORY = tuple(
    Keyword(f"DATABASE_HISTORY_{name}{of}", Rows(per_line=8, ids=integer(0)))
    for name in ENTITIES
    for of in ("", "_SET")
)

HISTORY_ID = tuple(
    Keyword(f"DATABASE_HISTORY_{name}_ID", Rows(id1=integer(above=0), heading=text("", width=70)))
    for name in ENTITIES
)

EXTENT_BINARY = Keyword(
    "DATABASE_EXTENT_BINARY",
    Card(
        neiph=integer(0),
        neips=integer(0),
        maxint=integer(3),
        strflg=integer(0),
        sigflg=integer(1),
        epsflg=integer(1),
        rltflg=integer(1),
        engflg=integer(1),
    ),
    Card(
        optional=True,
        cmpflg=integer(0),
        ieverp=integer(0),
        beamip=integer(0),
        dcomp=integer(1),
        shge=integer(1),
        stssz=integer(1),
        n3thdt=integer(2),
        ialemat=integer(1),
    ),
    Card(
        optional=True,
        nintsld=integer(0),
        pkp_sen=integer(0),
        sclp=real(1.0),
        hydro=integer(0),
        msscl=integer(0),
        therm=integer(0),
        intout=text(""),
        nodout=text(""),
    ),
    Card(
        optional=True,
        dtdt=integer(0),
        resplt=integer(0),
        neipb=integer(0),
        quadsld=integer(0),
        cubsld=integer(0),
        deleres=integer(0),
    ),
)

KEYWORDS = (*ASCII, *BINARY, BINARY_D3PROP, FORMAT, *HISTORY, *HISTORY_ID, EXTENT_BINARY)
