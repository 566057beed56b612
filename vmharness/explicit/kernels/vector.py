"""Vectors in space as tuples of three numbers, so that the code of a kernel reads like its equations.

The functions are inlined where they are called: the tuples become registers, and loops around them can be vectorised.
"""

from typing import TypeAlias

from vmharness.explicit.kernels.compiled import inlined as inlined
from vmharness.explicit.kernels.compiled import inlined_counted as inlined_counted
from vmharness.explicit.state import Array

Vector: TypeAlias = tuple[float, float, float]


@inlined
def row(a: Array, i: int) -> Vector:
    """Row i of an array (n, 3)."""
    return a[i, 0], a[i, 1], a[i, 2]


@inlined
def set_row(a: Array, i: int, b: Vector) -> None:
    """Set row i of an array (n, 3)."""
    a[i, 0], a[i, 1], a[i, 2] = b


@inlined
def add(a: Vector, b: Vector) -> Vector:
    """a + b."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


@inlined
def subtract(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@inlined
def scale(s: float, a: Vector) -> Vector:
    """s a."""
    return s * a[0], s * a[1], s * a[2]


@inlined
def dot(a: Vector, b: Vector) -> float:
    """a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inlined
def cross(a: Vector, b: Vector) -> Vector:
    """a x b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@inlined
def unit(a: Vector) -> Vector:
    """a / |a|."""
    return scale(1 / dot(a, a) ** 0.5, a)


@inlined
def components(triad: tuple[Vector, Vector, Vector], a: Vector) -> Vector:
    """Components (e1 . a, e2 . a, e3 . a) of a in an orthonormal triad."""
    return dot(triad[0], a), dot(triad[1], a), dot(triad[2], a)


@inlined
def combine(triad: tuple[Vector, Vector, Vector], a: Vector) -> Vector:
    """The vector a1 e1 + a2 e2 + a3 e3 of which `a` holds the components."""
    return add(add(scale(a[0], triad[0]), scale(a[1], triad[1])), scale(a[2], triad[2]))
