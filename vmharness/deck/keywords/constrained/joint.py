"""*CONSTRAINED_JOINT_SPHERICAL and _REVOLUTE: nodes of two rigid bodies that stay at one place."""

from vmharness.deck.card import Card
from vmharness.deck.field import Field, integer, real
from vmharness.deck.keyword import Keyword

RULES: dict[str, Field] = {
    "rps": real(1.0),  # these two serve joints by penalty
    "damp": real(1.0),
}
PAIR: dict[str, Field] = {"n1": integer(above=0), "n2": integer(above=0)}
LAST: dict[str, Field] = {"n5": integer(0), "n6": integer(0)}

CONSTRAINED_JOINT_SPHERICAL = Keyword(
    "CONSTRAINED_JOINT_SPHERICAL",
    Card({**PAIR, "n3": integer(0), "n4": integer(0), **LAST, **RULES}),
    options=("ID",),
    repeat=True,
)
CONSTRAINED_JOINT_REVOLUTE = Keyword(
    "CONSTRAINED_JOINT_REVOLUTE",
    Card({**PAIR, "n3": integer(above=0), "n4": integer(above=0), **LAST, **RULES}),
    options=("ID",),
    repeat=True,
)
