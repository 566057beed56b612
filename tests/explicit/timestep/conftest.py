"""Random decks of free meshes of every element, with random velocities: what must be stable at the default step."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

Array = NDArray[np.float64]
Rows = NDArray[np.int64]

E, RHO, SIDE = 2.0e11, 7800.0, 0.1
SPEED = 0.05  # of nodes: strains of 1e-5


def grid(rng: np.random.Generator, cells: tuple[int, ...], irregular: float) -> tuple[Array, Rows]:
    """Nodes (n, 3) of a grid of cells with random sides, and their numbers by place in the grid."""
    sides = SIDE * rng.uniform(0.5, 2.0, len(cells))
    n = np.arange(1, np.prod(np.array(cells) + 1) + 1).reshape(np.array(cells) + 1)
    x = np.zeros((n.size, 3))
    for k, index in enumerate(np.unravel_index(n.ravel() - 1, n.shape)):
        x[:, k] = index * sides[k]
    shift = irregular * sides.min() * rng.uniform(-1.0, 1.0, x.shape)
    return x + shift, n


def hexahedra(n: Rows) -> Rows:
    """The corners (ne, 8) of the cells of a grid in space."""
    low = [n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]]
    corners = [corner[..., :-1] for corner in low] + [corner[..., 1:] for corner in low]
    return np.stack(corners, axis=-1).reshape(-1, 8)


def wedges(n: Rows) -> Rows:
    """Two wedges for each cell: solids whose nodes 5 and 6, and 7 and 8, are the same."""
    a = hexahedra(n)[:, [0, 1, 5, 4, 3, 2, 6, 7]]  # two opposite faces 1-2-3-4 and 5-6-7-8 along y
    first = a[:, [0, 1, 5, 4, 3, 3, 7, 7]]
    second = a[:, [1, 2, 6, 5, 3, 3, 7, 7]]
    return np.concatenate([first, second])


def quadrilaterals(n: Rows) -> Rows:
    """The corners (ne, 4) of the cells of a grid in the plane."""
    return np.stack([n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]], axis=-1).reshape(-1, 4)


def triangles(n: Rows) -> Rows:
    """Two triangles for each cell, as quadrilaterals that repeat their third corner."""
    a = quadrilaterals(n)
    return np.concatenate([a[:, [0, 1, 2, 2]], a[:, [0, 2, 3, 3]]])


def table(keyword: str, rows: list[str]) -> str:
    """A keyword with its rows."""
    return "\n".join([keyword, *rows, ""])


def deck(x: Array, rng: np.random.Generator, nu: float, cards: str, gravity: bool, cycles: int) -> str:
    """A deck of nodes at `x` with random velocities and rotations; the elements are in `cards`."""
    v = rng.uniform(-SPEED, SPEED, x.shape) + (SPEED if gravity else 0.0)
    nodes = [f"{i},{a:.9g},{b:.9g},{c:.9g}" for i, (a, b, c) in enumerate(x, 1)]
    velocities = [f"{i},{a:.9g},{b:.9g},{c:.9g}" for i, (a, b, c) in enumerate(v, 1)]
    fall = "*LOAD_BODY_Z\n1,9.81\n*DEFINE_CURVE\n1\n0.0,1.0\n1e3,1.0\n" if gravity else ""
    return (
        f"*KEYWORD\n*CONTROL_TERMINATION\n100.0,{cycles}\n"
        + table("*NODE", nodes)
        + table("*INITIAL_VELOCITY_NODE", velocities)
        + f"*MAT_ELASTIC\n1,{RHO},{E},{nu}\n{fall}{cards}*END\n"
    )


def solids(rng: np.random.Generator, corners: Rows, elform: int, ihq: int, first: int = 1) -> str:
    """The cards of part 1 of solids."""
    rows = [f"{first + i},1," + ",".join(map(str, row)) for i, row in enumerate(corners)]
    hourglass = f"*HOURGLASS\n1,{ihq},{rng.uniform(0.03, 0.15):.3g}\n" if ihq else ""
    return f"*PART\nsolids\n1,1,1,0,{1 if ihq else 0}\n*SECTION_SOLID\n1,{elform}\n{hourglass}" + table(
        "*ELEMENT_SOLID", rows
    )


def shells(rng: np.random.Generator, corners: Rows, isdo: int, ihq: int) -> str:
    """The cards of part 1 of shells, thin or thick."""
    rows = [f"{i},1," + ",".join(map(str, row)) for i, row in enumerate(corners, 1)]
    t = SIDE * 10.0 ** rng.uniform(-2.5, 0.0)
    hourglass = f"*HOURGLASS\n1,{ihq},0.1\n" if ihq else ""
    return (
        f"*PART\nshells\n1,1,1,0,{1 if ihq else 0}\n*SECTION_SHELL\n1,2,{rng.uniform(0.8, 1.0):.3g},{rng.integers(1, 6)}\n{t:.5g}\n"
        f"*CONTROL_TIMESTEP\n,,{isdo}\n{hourglass}" + table("*ELEMENT_SHELL", rows)
    )


def beams(rng: np.random.Generator, pairs: Rows, elform: int) -> str:
    """The cards of part 2 of beams (ELFORM 2) or trusses (3) between pairs of nodes."""
    r = SIDE * 10.0 ** rng.uniform(-2.0, -0.5)
    area, moment = np.pi * r**2, np.pi * r**4 / 4
    section = f"{area:.6g},{moment:.6g},{moment * rng.uniform(0.2, 1.0):.6g},{2 * moment:.6g}"
    third = ",{}" if elform == 2 else ""
    rows = [f"{1000 + i},2,{a},{b}" + third.format(9999) for i, (a, b) in enumerate(pairs)]
    guide = "*NODE\n9999,1.1,13.7,-5.3,7,7\n" if elform == 2 else ""
    size = section if elform == 2 else f"{area:.6g},"
    return f"*PART\nbeams\n2,2,1\n*SECTION_BEAM\n2,{elform}\n{size}\n{guide}" + table("*ELEMENT_BEAM", rows)


def springs(rng: np.random.Generator, pairs: Rows, damped: bool, about: int = 0) -> str:
    """The cards of part 3 (and 4) of springs, and of dampers beside them, from weak to far stiffer than elements."""
    k = E * SIDE * 10.0 ** rng.uniform(-3.0, 1.0) * (SIDE**2 if about else 1.0)
    c = (k * RHO * SIDE**3) ** 0.5 * rng.uniform(0.1, 1.0) * (SIDE if about else 1.0)
    rows = [f"{2000 + i},3,{a},{b}" for i, (a, b) in enumerate(pairs)]
    text = f"*PART\nsprings\n3,3,3\n*SECTION_DISCRETE\n3,{about}\n\n*MAT_SPRING_ELASTIC\n3,{k:.6g}\n"
    if damped:
        rows += [f"{3000 + i},4,{a},{b}" for i, (a, b) in enumerate(pairs)]
        text += f"*PART\ndampers\n4,3,4\n*MAT_DAMPER_VISCOUS\n4,{c:.6g}\n"
    return text + table("*ELEMENT_DISCRETE", rows)


def masses(rng: np.random.Generator, count: int, some: int) -> str:
    """Lumped masses on some nodes, from light to heavy."""
    nodes = rng.choice(count, some, replace=False) + 1
    rows = [
        f"{4000 + i},{node},{RHO * SIDE**3 * 10.0 ** rng.uniform(-3.0, 1.0):.6g}"
        for i, node in enumerate(nodes)
    ]
    return table("*ELEMENT_MASS", rows)


def pairs_of(rng: np.random.Generator, count: int, some: int) -> Rows:
    """Random pairs of different nodes."""
    return np.array([rng.choice(count, 2, replace=False) + 1 for _ in range(some)])


POISSON = (0.0, 0.2, 0.3, 0.4, 0.45)


def of_solids(rng: np.random.Generator, shape: str, elform: int, cycles: int, extra: bool = False) -> str:
    """A mesh of 1 to 12 solids, perhaps with springs, bars and masses between its nodes."""
    cells = tuple(rng.integers(1, 4, 3)) if shape == "hexahedra" else tuple(rng.integers(1, 3, 3))
    x, n = grid(rng, cells, rng.choice([0.0, 0.1, 0.25]))
    corners = hexahedra(n) if shape == "hexahedra" else wedges(n)
    cards = solids(rng, corners, elform, int(rng.choice([0, 1, 2, 4])) if elform == 1 else 0)
    if extra:
        cards += springs(rng, pairs_of(rng, len(x), 2), bool(rng.integers(2))) + masses(rng, len(x), 2)
        cards += beams(rng, pairs_of(rng, len(x), 2), 3)
    return deck(x, rng, float(rng.choice(POISSON)), cards, bool(rng.integers(2)), cycles)


def of_shells(rng: np.random.Generator, shape: str, isdo: int, cycles: int, extra: bool = False) -> str:
    """A mesh of 1 to 18 shells, flat or warped, perhaps with springs, torsional ones, beams and masses."""
    x, n = grid(rng, tuple(rng.integers(1, 4, 2)), rng.choice([0.0, 0.1, 0.2]))
    x[:, 2] *= rng.choice([0.0, 1.0])
    corners = quadrilaterals(n) if shape == "quadrilaterals" else triangles(n)
    cards = shells(rng, corners, isdo, int(rng.choice([0, 1, 4])))
    if extra:
        cards += springs(rng, pairs_of(rng, len(x), 2), bool(rng.integers(2)), int(rng.integers(2)))
        cards += masses(rng, len(x), 2) + beams(rng, pairs_of(rng, len(x), 2), 2)
    return deck(x, rng, float(rng.choice(POISSON)), cards, bool(rng.integers(2)), cycles)


def of_beams(rng: np.random.Generator, elform: int, cycles: int, extra: bool = False) -> str:
    """A frame or a truss between random nodes, perhaps with springs and masses."""
    x = SIDE * 5.0 * rng.uniform(-1.0, 1.0, (6, 3))
    chain = np.stack([np.arange(1, 6), np.arange(2, 7)], axis=1)
    cards = beams(rng, np.concatenate([chain, [[1, 3], [2, 5]]]), elform)
    if extra:
        cards += springs(rng, pairs_of(rng, len(x), 2), bool(rng.integers(2))) + masses(rng, len(x), 2)
    return deck(x, rng, 0.3, cards, bool(rng.integers(2)), cycles)


KINDS: dict[str, tuple[Callable[..., str], tuple[Any, ...]]] = {
    **{
        f"{shape} of ELFORM {elform}": (of_solids, (shape, elform))
        for elform in (1, 2)
        for shape in ("hexahedra", "wedges")
    },
    **{
        f"{shape} with ISDO {isdo}": (of_shells, (shape, isdo))
        for shape in ("quadrilaterals", "triangles")
        for isdo in (0, 1, 2)
    },
    "beams": (of_beams, (2,)),
    "trusses": (of_beams, (3,)),
}


@pytest.fixture
def free_mesh() -> Callable[..., str]:
    """A deck of a random free mesh: kind, number of the random choice, cycles, whether with springs and masses."""

    def made(kind: str, seed: int, cycles: int, extra: bool) -> str:
        make, given = KINDS[kind]
        return make(np.random.default_rng([seed, len(kind)]), *given, cycles, extra)

    return made
