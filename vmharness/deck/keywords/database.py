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

OTHERS = """
ABSTAT ABSTAT_CPM ABSTAT_MASS_FLOW ACEOUT ALE ALE_MAT ATDOUT AVSFLT BEARING BINARY_BLSTFOR BINARY_CPMFOR
BINARY_D3ALE BINARY_D3CRACK BINARY_D3CRCK BINARY_D3DRLF BINARY_D3PSD BINARY_D3RMS BINARY_D3SPCM BINARY_D3SSD
BINARY_DEMFOR BINARY_DEMRCF BINARY_FSIFOR BINARY_FSILNK BINARY_INTFOR_FILE BINARY_ISPHFOR BINARY_PBMFOR
BINARY_RCTRAK BINARY_XTFILE CPM_SENSOR CPMFOR CROSS_SECTION_PLANE CROSS_SECTION_PLANE_ID CROSS_SECTION_SET
CROSS_SECTION_SET_ID CURVOUT D3FTG D3MAX DCFAIL DEFGEO DEMASSFLOW DISBOUT EXTENT_AVS EXTENT_D3PART EXTENT_INTFOR
EXTENT_MOVIE EXTENT_MPGS EXTENT_SSSTAT FATXML FREQUENCY_ASCII FREQUENCY_BINARY_D3FTG FREQUENCY_BINARY_D3PSD
FREQUENCY_BINARY_D3RMS FREQUENCY_BINARY_D3SPCM FREQUENCY_BINARY_D3SSD FSI FSI_SENSOR GCEOUT H3OUT ISPHHTC JNTFORC_LOCAL
MASSOUT MAX MOVIE MPGS NODAL_FORCE_GROUP NODOUTHF NODOUT_HF PAP_OUTPUT PBLAST_SENSOR PBSTAT PLLYOUT PROFILE PRTUBE
PWP_FLOW PWP_OUTPUT PYRO RCFORC_MOMENT RECOVER_NODE RVE SBTOUT SENSOR SPHMASSFLOW SPHOUT SPRING_FORWARD
SSSTAT_MASS_PROPERTIES SUPERPLASTIC_FORMING SWFORC TRACER TRACER_GENERATE TRHIST
"""

OTHER_HISTORIES = (
    *(
        f"{name}{of}"
        for name in ("SEATBELT", "SEATBELT_RETRACTOR", "SEATBELT_SLIPRING", "SPH", "DES", "TSHELL")
        for of in ("", "_ID", "_SET")
    ),
    *(f"NODE{of}_LOCAL{id}" for of in ("", "_SET") for id in ("", "_ID")),
    *("ACOUSTIC", "SHELL_SET_ID", "SOLID_SET_ID", "BEAM_SET_ID", "NODE_SET_ID", "DISCRETE_SET_ID"),
)

UNREAD = tuple(Keyword(f"DATABASE_{name}") for name in OTHERS.split()) + tuple(
    Keyword(f"DATABASE_HISTORY_{name}") for name in OTHER_HISTORIES
)

KEYWORDS = (*ASCII, *BINARY, BINARY_D3PROP, FORMAT, *HISTORY, *HISTORY_ID, EXTENT_BINARY, *UNREAD)
