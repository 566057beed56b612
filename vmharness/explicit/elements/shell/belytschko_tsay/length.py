"""Characteristic length and wave speed, whose quotient is the element's stable step (LS-DYNA: ISDO 0, 1, 2).

    ISDO 0   L_s = A / longest side                             c = sqrt(E / (rho (1 - nu^2)))
    ISDO 1   L_s = A / longest diagonal                         c as above
    ISDO 2   L_s = max(shortest side, A / longest side)         c = sqrt(E / rho)

The estimate is the classical one, not a bound: a single free square is stable only up to L_s / (c sqrt(1 + nu)), the
limit of the mode that stretches it in all directions (0.877 at nu = 0.3, less than the 0.9 of TSSFAC). Neighbours and
supports raise the limit. timestep/stable_step.py sees to shells that have neither.
"""

from vmharness.explicit.elements.shell.belytschko_tsay.frame import Corners
from vmharness.explicit.kernels.vector import Vector, cross, dot, inlined, subtract


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


LENGTHS = (by_side, by_diagonal, by_bar)  # by ISDO
