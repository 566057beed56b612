"""The model of CalculiX while it is translated: lines of its input file, and what later lines must know.

Nodes have their row, counted from 1, as number, and elements the order in which they are added: CalculiX allots memory
up to the largest number, and elements of all kinds share one numbering.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Keyword
from vmharness.mesh.nodes import Array, Nodes
from vmharness.mesh.supports import supported

Lines = list[str]


@dataclass(frozen=True)
class Member:
    """An element: its number in CalculiX, the rows of its nodes, and the stress of the deck over that of CalculiX."""

    number: int
    rows: tuple[int, ...]
    stress: float = 1.0


@dataclass
class Model:
    """Input for a deck."""

    deck: Deck
    nodes: Nodes
    mass: Array  # (n,) of elements and lumped masses
    lumped: Array  # (n,) of lumped masses alone
    used: NDArray[np.bool_]  # (n,) nodes that an element joins
    expanded: NDArray[
        np.bool_
    ]  # (n,) nodes of elements that CalculiX expands to solids: trusses, beams, shells
    rotating: NDArray[np.bool_]  # (n,) nodes of beams and shells
    held: NDArray[np.bool_]  # (n, 6) degrees of freedom that supports hold
    stiff: Array  # (n,) bound of the row sums of |K| at the nodes
    velocities: Array  # (n, 3)
    elements: Lines = field(default_factory=list)  # and the properties of springs, dampers and masses
    materials: dict[str, Lines] = field(default_factory=dict)
    sections: Lines = field(default_factory=list)
    equations: Lines = field(default_factory=list)
    corners: dict[int, dict[float, list[int]]] = field(
        default_factory=dict
    )  # numbers of added nodes, by row and side
    added: list[Array] = field(default_factory=list)  # coordinates of added nodes
    motions: dict[str, tuple[Array, Array]] = field(
        default_factory=dict
    )  # amplitude: times and displacements
    driven: Lines = field(default_factory=list)  # *BOUNDARY of the step
    loads: dict[tuple[int, int], dict[int, float]] = field(
        default_factory=dict
    )  # (row, axis): factor by LCID
    members: dict[tuple[str, int], Member] = field(default_factory=dict)  # (keyword, EID)
    work: float = 0.0  # elements that are solids to CalculiX, by the time that a step takes for them
    kicked: bool = False  # it has elements that a sudden load sets into vibration: see clock.py
    preloaded: bool = False  # the strain energy of springs has another zero
    count: int = 0  # elements so far

    def add(
        self,
        keyword: Keyword,
        eid: int,
        kind: str,
        name: str,
        rows: Sequence[int],
        numbers: Sequence[int] = (),
        stress: float = 1.0,
    ) -> None:
        """Add an element of a type of CalculiX to the element set `name`; its nodes are the rows, or the `numbers`."""
        self.count += 1
        rows = [int(row) for row in rows]
        self.used[rows] = True
        self.members[keyword.name, eid] = Member(self.count, tuple(rows), stress)
        self.elements += [
            f"*ELEMENT,TYPE={kind},ELSET={name}",
            ",".join(map(str, [self.count, *(numbers or [1 + row for row in rows])])),
        ]

    def join(self, first: int, second: int, stiffness: float) -> None:
        """Note that an element of this stiffness joins two rows of nodes: each has K_ii = k and K_ij = -k of it."""
        self.stiff[[first, second]] += 2.0 * stiffness

    def load(self, row: int, axis: int, lcid: int, factor: float) -> None:
        """Add a force on a node: a factor times a curve."""
        curves = self.loads.setdefault((row, axis), {})
        curves[lcid] = curves.get(lcid, 0.0) + factor

    def length(self, first: int, second: int) -> float:
        """The distance of two rows of nodes at the beginning."""
        return float(np.linalg.norm(self.nodes.x0[second] - self.nodes.x0[first]))


def empty(deck: Deck, nodes: Nodes) -> Model:
    """A model without elements."""
    n = nodes.ids.size
    return Model(
        deck,
        nodes,
        mass=np.zeros(n),
        lumped=np.zeros(n),
        used=np.zeros(n, bool),
        expanded=np.zeros(n, bool),
        rotating=np.zeros(n, bool),
        held=supported(deck, nodes),
        stiff=np.zeros(n),
        velocities=np.zeros((n, 3)),
    )


def real(value: float) -> str:
    """A number in at most 20 characters, with a decimal point.

    CalculiX drops the rest of a longer field, also where that is the exponent, and takes a number without a point for
    a degree of freedom where both may stand.

    >>> real(1.0), real(1e-5), real(-1.234567890123456e-100)
    ('1.', '1.e-05', '-1.234567890123e-100')
    """
    digits, letter, exponent = f"{value:.13g}".partition("e")
    return f"{digits}{'' if '.' in digits else '.'}{letter}{exponent}"


def table(values: Iterable[float], width: int) -> Lines:
    """Lines of `width` numbers."""
    words = [real(float(value)) for value in values]
    return [",".join(words[i : i + width]) for i in range(0, len(words), width)]
