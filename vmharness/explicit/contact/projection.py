"""Where a node is against a segment."""

from vmharness.explicit.contact.geometry import closest, corners, polynomial
from vmharness.explicit.contact.records import Record
from vmharness.explicit.kernels.vector import Vector, add, cross, inlined, scale, subtract, unit
from vmharness.explicit.model.state import Array


@inlined
def place(
    x: Array, segment: Record, p: Vector, xi: float, eta: float
) -> tuple[float, float, float, Vector, Vector]:
    """Closest point xi, eta; how far beyond the border p projects; p - r; and the normal there.

    (xi, eta) is the first guess.
    """
    c = corners(x, segment["nodes"])
    xi, eta, out = closest(segment["triangle"], c, p, xi, eta)
    o, a, b, w = polynomial(segment["triangle"], c)
    along = add(a, scale(eta, w))  # r,xi; and r = o + eta b + xi r,xi
    away = subtract(p, add(o, add(scale(eta, b), scale(xi, along))))
    return xi, eta, out, away, unit(cross(along, add(b, scale(xi, w))))


@inlined
def half_thickness(node: Record, segment: Record) -> float:
    """The distance between mid-surfaces at which the surfaces touch, (t_node + t_segment)/2."""
    return float(0.5 * (node["thickness"] + segment["thickness"]))


@inlined
def first_guess(triangle: bool) -> tuple[float, float]:
    """The middle of a segment."""
    return (1.0 / 3.0, 1.0 / 3.0) if triangle else (0.0, 0.0)
