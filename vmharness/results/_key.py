"""Quantities of result files."""

from collections.abc import Mapping
from typing import NamedTuple


class Key(NamedTuple):
    """A quantity over time: the component of a thing.

    >>> str(Key("node", "z-displacement", 5)), str(Key("energy", "kinetic")), str(Key("shell", "xx-stress", 7, 2))
    ('z-displacement of node 5', 'kinetic energy', 'xx-stress of shell 7, point 2')
    """

    kind: str  # node, part, contact, support, wall, ..., or energy, model, column
    component: str
    number: int = 0  # of the thing; 0 for all
    point: int = 0  # integration point, where the thing has several

    def __str__(self) -> str:
        if self.kind in ("energy", "column"):
            return f"{self.component} energy" if self.kind == "energy" else f"column {self.component}"
        of = f"{self.kind} {self.number}" if self.number else f"the {self.kind}"
        return f"{self.component} of {of}" + (f", point {self.point}" if self.point else "")


Sum = Mapping[Key, float]  # a linear combination of quantities: their factors
