"""*CONTROL_ENERGY: which energies are computed."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer
from vmharness.deck.keyword import Keyword

DEFAULTS = {
    "hgen": 1,
    "rwen": 2,
    "slnten": 1,
    "rylen": 1,
    "irgen": 2,
    "maten": 1,
    "drlen": 1,
    "disen": 1,
}

CONTROL_ENERGY = Keyword(
    "CONTROL_ENERGY",
    Card({name: integer(on, zero_is_default=True) for name, on in DEFAULTS.items()}),
    single=True,
)
