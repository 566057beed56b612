"""*MAT_PIECEWISE_LINEAR_PLASTICITY (024): plasticity with a curve of the yield stress."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real, skip
from vmharness.deck.keyword import Keyword

EPS = tuple(f"eps{i}" for i in range(1, 9))

ES = tuple(f"es{i}" for i in range(1, 9))

MAT_PIECEWISE_LINEAR_PLASTICITY = Keyword(
    "MAT_PIECEWISE_LINEAR_PLASTICITY",
    Card(
        mid=integer(above=0),
        ro=real(),
        e=real(),
        pr=real(0.0),
        sigy=real(0.0),
        etan=real(0.0),
        fail=real(1e21),
        tdel=real(0.0),
    ),
    Card(
        c=real(0.0),
        p=real(0.0),
        lcss=integer(0),
        lcsr=integer(0),
        vp=real(0.0),
        _6=skip(),
        rfiltf=real(0.0),
    ),
    Card({name: real(0.0) for name in EPS}),
    Card({name: real(0.0) for name in ES}),
    aliases=("MAT_024",),
    options=("TITLE",),
    repeat=True,
    unique="mid",
    kind="material",
)
