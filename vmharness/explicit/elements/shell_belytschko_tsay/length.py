"""Characteristic length and wave speed, whose quotient is the element's stable step (LS-DYNA: ISDO 0, 1, 2).

    ISDO 0   L_s = A / longest side                             c = sqrt(E / (rho (1 - nu^2)))
    ISDO 1   L_s = A / longest diagonal                         c as above
    ISDO 2   L_s = max(shortest side, A / longest side)         c = sqrt(E / rho)

The estimate is the classical one, not a bound: a lone free square is stable only up to L_s / (c sqrt(1 + nu)), by the
mode that stretches it in all directions (0.877 at nu = 0.3, less than the 0.9 of TSSFAC). Neighbours and supports make
up for that; a shell that has neither needs TSSFAC = 0.8, and the energy balance ends a run that diverges.
"""

from math import sqrt

from vmharness.explicit.elements.shell_belytschko_tsay.frame import Corners
from vmharness.explicit.lanes import Indices
from vmharness.explicit.state import Array
from vmharness.explicit.vector import Vector, cross, dot, inlined, subtract


@inlined
def squared(a: Vector) -> float:
    """|a|^2."""
    return dot(a, a)


@inlined
def area(x: Corners) -> float:
    """A = |r13 x r24| / 2."""
    return 0.5 * squared(cross(subtract(x[0], x[2]), subtract(x[1], x[3]))) ** 0.5


@inlined
def longest_side(x: Corners) -> float:
    """The longest of the four sides."""
    a, b = squared(subtract(x[1], x[0])), squared(subtract(x[2], x[1]))
    c, d = squared(subtract(x[3], x[2])), squared(subtract(x[0], x[3]))
    return max(max(a, b), max(c, d)) ** 0.5


@inlined
def shortest_side(x: Corners) -> float:
    """The shortest of the four sides."""
    a, b = squared(subtract(x[1], x[0])), squared(subtract(x[2], x[1]))
    c, d = squared(subtract(x[3], x[2])), squared(subtract(x[0], x[3]))
    return min(min(a, b), min(c, d)) ** 0.5


@inlined
def by_side(x: Corners) -> float:
    """ISDO 0: A / longest side."""
    return area(x) / longest_side(x)


@inlined
def by_diagonal(x: Corners) -> float:
    """ISDO 1: A / longest diagonal."""
    return area(x) / max(squared(subtract(x[0], x[2])), squared(subtract(x[1], x[3]))) ** 0.5


@inlined
def by_bar(x: Corners) -> float:
    """ISDO 2: max(shortest side, A / longest side)."""
    return max(shortest_side(x), area(x) / longest_side(x))


def lengths(x: Array, nodes: Indices, out: Array) -> None:
    """L_s of each element; `x (n, 3)`, `nodes (ne, 4)`, `out (ne,)`."""
    for e in range(len(nodes)):
        i, j, k, m = nodes[e]
        out[e] = length((
            (x[i, 0], x[i, 1], x[i, 2]),
            (x[j, 0], x[j, 1], x[j, 2]),
            (x[k, 0], x[k, 1], x[k, 2]),
            (x[m, 0], x[m, 1], x[m, 2]),
        ))  # fmt: skip


length = by_side
LENGTHS = (by_side, by_diagonal, by_bar)  # by ISDO


def wave_speed(stiffness: tuple[float, float], density: float, isdo: int) -> float:
    """Speed c that goes with the length of ISDO; `stiffness`: E and nu; consistent units.

    >>> round(wave_speed((210.0, 0.3), 7.8e-6, 0), 2)
    5439.28
    """
    E, nu = stiffness
    return sqrt(E / density) if isdo == 2 else sqrt(E / (density * (1 - nu * nu)))
