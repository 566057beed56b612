"""*DATABASE_...: what LS-DYNA writes, and how often."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword

EFFECT = "asks for output files; no effect on results."

ASCII = tuple(
    Keyword(
        f"DATABASE_{name}",
        Card(
            dt=real(0.0, at_least=0.0),
            binary=integer(0),
            lcur=integer(0),
            ioopt=integer(1),
            option1=real(0.0),
            option2=integer(0),
            option3=integer(0),
            option4=integer(0),
        ),
        effect=EFFECT,
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
    )
)

BINARY = tuple(
    Keyword(
        f"DATABASE_BINARY_{name}",
        Card(
            dt=real(0.0, at_least=0.0),
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
        effect=EFFECT,
    )
    for name in ("D3PLOT", "D3THDT", "INTFOR")
)

HISTORY = tuple(
    Keyword(f"DATABASE_HISTORY_{name}", Rows(per_line=8, ids=integer(0)), effect=EFFECT)
    for name in ("NODE", "NODE_SET", "SHELL", "SHELL_SET", "SOLID", "SOLID_SET")
)

HISTORY_NODE_ID = Keyword(
    "DATABASE_HISTORY_NODE_ID", Rows(id1=integer(above=0), heading=text("", width=70)), effect=EFFECT
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
    effect=EFFECT,
)
