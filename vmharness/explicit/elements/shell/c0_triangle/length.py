"""Characteristic length of the stable step (LS-DYNA: ISDO 0, 1, 2).

    ISDO 0, 1   L_s = 2 A / longest side, the smallest height
    ISDO 2      L_s = max(shortest side, 2 A / longest side)

The estimate is the classical one, not a bound: a single free triangle is stable only up to 0.78 to 0.94 L_s / c, the
limit of the modes of its membrane (equilateral: 2 sqrt 2 / 3 / sqrt(1 + nu), 0.83 at nu = 0.3). A free square of two
triangles is stable up to 0.94, one of eighteen up to 0.97. timestep/stable_step.py sees to such meshes.
"""

from vmharness.explicit.elements.shell.c0_triangle.frame import Corners
from vmharness.explicit.kernels.vector import cross, dot, inlined, subtract


@inlined
def smallest_height(x: Corners) -> float:
    """ISDO 0 and 1: 2 A / longest side."""
    a, b, c = subtract(x[1], x[0]), subtract(x[2], x[1]), subtract(x[0], x[2])
    normal = cross(a, b)
    return (dot(normal, normal) / max(dot(a, a), max(dot(b, b), dot(c, c)))) ** 0.5


@inlined
def height_or_side(x: Corners) -> float:
    """ISDO 2: max(shortest side, 2 A / longest side)."""
    a, b, c = subtract(x[1], x[0]), subtract(x[2], x[1]), subtract(x[0], x[2])
    return max(min(dot(a, a), min(dot(b, b), dot(c, c))) ** 0.5, smallest_height(x))


LENGTHS = (smallest_height, smallest_height, height_or_side)  # by ISDO
