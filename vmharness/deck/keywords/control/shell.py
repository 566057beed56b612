"""*CONTROL_SHELL: options of all shells, such as ISTUPD: whether their thickness follows the strain through it."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

CONTROL_SHELL = Keyword(
    "CONTROL_SHELL",
    Card(
        wrpang=real(20.0),  # angle of a warning
        esort=integer(0),  # 1 makes C0 triangles of degenerate shells
        irnxx=integer(-1),  # fibre directions
        istupd=integer(0),
        theory=integer(2, zero_is_default=True),
        bwc=integer(2, zero_is_default=True),
        miter=integer(1, zero_is_default=True),
        proj=integer(0),
    ),
    Card(
        optional=True,
        rotascl=real(1.0),
        intgrd=integer(0),
        lamsht=integer(0),
        cstyp6=integer(1),
        thshel=integer(0),
    ),
    Card(
        optional=True,
        pstupd=integer(0),
        sidt4tu=integer(0),
        cntco=integer(0),
        itsflg=integer(0),
        irquad=integer(3),
        w_mode=real(0.0),
        stretch=real(0.0),
        icrq=integer(0),
    ),
    Card(
        optional=True,
        nfail1=integer(0),
        nfail4=integer(0),
        psnfail=integer(0),
        keepcs=integer(0),
        delfr=integer(0),
        drcpsid=integer(0),
        drcprm=real(1.0),
        intperr=integer(0),
    ),
    Card(optional=True, drcmth=integer(0), lispsid=integer(0), nlocdt=integer(0), iswshl=integer(0)),
    single=True,
)
