"""Motion of a node against the segment that it touches."""

from vmharness.explicit.contact.geometry import Weights, at, at_time, corners, interpolate
from vmharness.explicit.contact.moment_balance import about_middle, spin
from vmharness.explicit.contact.records import Record
from vmharness.explicit.kernels.vector import Vector, cross, inlined, scale, subtract
from vmharness.explicit.model.state import Array


@inlined
def relative(field: Array, row: int, segment: Record, weights: Weights) -> Vector:
    """v - sum N_i v_i of a field (n, 3)."""
    return subtract(at(field, row), interpolate(corners(field, segment["nodes"]), weights))


@inlined
def carried(x: Array, v: Array, row: int, segment: Record, weights: Weights, back: float) -> Vector:
    """The velocity of the point that is rigidly with the segment at the node, against the point that it touches.

    Positions are those a time `back` ago.
    """
    moved = corners(v, segment["nodes"])
    c = at_time(corners(x, segment["nodes"]), moved, back)
    arm = subtract(subtract(at(x, row), scale(back, at(v, row))), interpolate(c, weights))
    return cross(spin(about_middle(c), moved), arm)
