"""*MAT_RIGID (020): the part is one rigid body."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, only, real, text
from vmharness.deck.keyword import Keyword
from vmharness.deck.keywords.node import CODES

MAT_RIGID = Keyword(
    "MAT_RIGID",
    Card(
        mid=integer(above=0),
        ro=real(above=0.0),
        e=real(above=0.0),
        pr=real(0.0),
        n=only(0.0),
        couple=only(0.0),
        m=only(0.0),
        alias=text(""),
    ),
    Card(
        cmo=integer(0, choices=(0, 1)),
        con1=integer(0, choices=CODES),
        con2=integer(0, choices=CODES),
        spcnid=only(0),
        xspc=only(0.0),
        yspc=only(0.0),
        zspc=only(0.0),
    ),
    Card(lco=real(0.0), a2=real(0.0), a3=real(0.0), v1=real(0.0), v2=real(0.0), v3=real(0.0), bndlco=only(0)),
    aliases=("MAT_020",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
