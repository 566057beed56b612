"""*CONTROL_CONTACT: defaults of all contacts."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, skip
from vmharness.deck.keyword import Keyword

CONTROL_CONTACT = Keyword(
    "CONTROL_CONTACT",
    Card(
        slsfac=real(0.1, zero_is_default=True),
        rwpnal=real(0.0),  # penalty of rigid bodies at rigid walls
        islchk=integer(1, zero_is_default=True),
        shlthk=integer(0),
        penopt=integer(1, zero_is_default=True),
        thkchg=integer(0),
        orien=integer(1, zero_is_default=True),
        enmass=integer(0),
    ),
    Card(
        usrstr=integer(0),
        usrfrc=integer(0),
        nsbcs=integer(0),
        interm=integer(0),
        xpene=real(4.0, zero_is_default=True),
        ssthk=integer(0),
        ecdt=integer(0),
        tiedprj=integer(0),
    ),
    Card(
        optional=True,
        sfric=real(0.0),  # friction by part
        dfric=real(0.0),
        edc=real(0.0),
        vfc=real(0.0),
        th=real(0.0),
        th_sf=real(0.0),
        pen_sf=real(0.0),
        ptscl=real(1.0, zero_is_default=True),
    ),
    Card(
        optional=True,
        ignore=integer(0),
        frceng=integer(0),
        skiprwg=integer(0),
        outseg=integer(0),
        spotstp=integer(0),
        spotdel=integer(0),
        spothin=real(0.0),
        dir_tie=integer(0),
    ),
    Card(
        optional=True,
        isym=integer(0),
        nserod=integer(0),
        rwgaps=integer(1),
        rwgdth=real(0.0),
        rwksf=real(1.0, zero_is_default=True),
        icov=integer(0),
        swradf=real(0.0),
        ithoff=integer(0),
    ),
    Card(
        optional=True,
        shledg=integer(0),
        pstiff=integer(0),
        ithcnt=integer(0),
        tdcnof=integer(0),
        ftall=integer(0),
        _6=skip(),
        shltrw=real(0.0),
        igactc=integer(0),
    ),
    Card(
        optional=True,
        irevspt=integer(0),
        _2=skip(),
        cohtiem=integer(0),
        tieopt=integer(0),
        strobj=integer(0),
        befblk=real(0.0),
    ),
    single=True,
)
