"""*CONTROL_CONTACT: defaults of all contacts; what acts on none is said in the run's facts."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real, skip
from vmharness.deck.keyword import Keyword

CONTROL_CONTACT = Keyword(
    "CONTROL_CONTACT",
    Card(
        slsfac=real(0.1, zero_is_default=True, above=0.0),
        rwpnal=real(0.0, at_least=0.0),  # penalty of rigid bodies at rigid walls
        islchk=integer(1, choices=(1, 2), zero_is_default=True),
        shlthk=integer(0, choices=(0, 1, 2)),
        penopt=integer(1, choices=(1, 2), zero_is_default=True),
        thkchg=only(0),
        orien=integer(1, choices=(1, 2, 4), zero_is_default=True),
        enmass=only(0),
    ),
    Card(
        usrstr=only(0),
        usrfrc=only(0),
        nsbcs=integer(0),
        interm=only(0),
        xpene=real(4.0, zero_is_default=True, above=0.0),
        ssthk=integer(0, choices=(0, 1)),
        ecdt=integer(0, choices=(0, 1)),
        tiedprj=integer(0, choices=(0, 1)),
    ),
    Card(
        optional=True,
        sfric=only(0.0),  # friction by part
        dfric=only(0.0),
        edc=only(0.0),
        vfc=only(0.0),
        th=only(0.0),
        th_sf=only(0.0),
        pen_sf=only(0.0),
        ptscl=only(1.0, zero_is_default=True),
    ),
    Card(
        optional=True,
        ignore=integer(0, choices=(0, 1, 2)),
        frceng=integer(0, choices=(0, 1)),
        skiprwg=integer(0, choices=(0, 1)),
        outseg=integer(0, choices=(0, 1)),
        spotstp=only(0),
        spotdel=only(0),
        spothin=only(0.0),
        dir_tie=only(0),
    ),
    Card(
        optional=True,
        isym=only(0),
        nserod=only(0),
        rwgaps=integer(1, choices=(0, 1)),
        rwgdth=only(0.0),
        rwksf=only(1.0, zero_is_default=True),
        icov=only(0),
        swradf=only(0.0),
        ithoff=only(0),
    ),
    Card(
        optional=True,
        shledg=only(0),
        pstiff=only(0),
        ithcnt=only(0),
        tdcnof=only(0),
        ftall=integer(0, choices=(0, 1)),
        _6=skip(),
        shltrw=only(0.0),
        igactc=only(0),
    ),
    Card(
        optional=True,
        irevspt=only(0),
        _2=skip(),
        cohtiem=only(0),
        tieopt=only(0),
        strobj=only(0),
        befblk=only(0.0),
    ),
    single=True,
)
