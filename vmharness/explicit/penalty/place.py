"""Where a node is against a segment."""

from vmharness.explicit.penalty.touch import Record
from vmharness.explicit.segment import closest, corners, interpolate, normal, shape
from vmharness.explicit.state import Array
from vmharness.explicit.vector import Vector, inlined, subtract


@inlined
def place(
    x: Array, segment: Record, p: Vector, xi: float, eta: float
) -> tuple[float, float, float, Vector, Vector]:
    """Closest point xi, eta; how far beyond the border p projects; p - r; and the normal there.

    (xi, eta) is the first guess.
    """
    c = corners(x, segment["nodes"])
    xi, eta, out = closest(segment["triangle"], c, p, xi, eta)
    away = subtract(p, interpolate(c, shape(segment["triangle"], xi, eta)))
    return xi, eta, out, away, normal(segment["triangle"], c, xi, eta)


@inlined
def half_thickness(node: Record, segment: Record) -> float:
    """The distance between mid-surfaces at which the surfaces touch, (t_node + t_segment)/2."""
    return float(0.5 * (node["thickness"] + segment["thickness"]))


@inlined
def first_guess(triangle: bool) -> tuple[float, float]:
    """The middle of a segment."""
    return (1.0 / 3.0, 1.0 / 3.0) if triangle else (0.0, 0.0)
