"""*MAT_RIGID (020): the part is one rigid body."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword

MAT_RIGID = Keyword(
    "MAT_RIGID",
    Card(
        mid=integer(above=0),
        ro=real(),
        e=real(),
        pr=real(0.0),
        n=real(0.0),
        couple=real(0.0),
        m=real(0.0),
        alias=text(""),
    ),
    Card(
        cmo=integer(0),
        con1=integer(0),
        con2=integer(0),
        spcnid=integer(0),
        xspc=real(0.0),
        yspc=real(0.0),
        zspc=real(0.0),
    ),
    Card(
        lco=real(0.0), a2=real(0.0), a3=real(0.0), v1=real(0.0), v2=real(0.0), v3=real(0.0), bndlco=integer(0)
    ),
    aliases=("MAT_020",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
