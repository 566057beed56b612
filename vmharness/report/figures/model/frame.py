"""From the space of a model to the canvas: isometric view, as large as the room allows, in points."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# Rows are the directions of the drawing, to the right and up: the axes 120 degrees apart, z upright.
ISOMETRIC = np.array([[np.sqrt(3.0) / 2.0, -np.sqrt(3.0) / 2.0, 0.0], [0.5, 0.5, 1.0]])
VIEWER = np.cross(*ISOMETRIC)  # toward the eye
DIGITS = 6  # of a place in points: the last bits of coordinates move no label


@dataclass(frozen=True)
class Box:
    """A rectangle, in points."""

    left: float
    bottom: float
    right: float
    top: float

    def meets(self, other: "Box") -> bool:
        """Whether the two have a common area."""
        return (
            self.left < other.right
            and other.left < self.right
            and self.bottom < other.top
            and other.bottom < self.top
        )

    def inside(self, other: "Box") -> bool:
        """Whether it lies in `other` as a whole."""
        return (
            other.left <= self.left
            and self.right <= other.right
            and other.bottom <= self.bottom
            and self.top <= other.top
        )


@dataclass(frozen=True)
class Frame:
    """The scale of a drawing, and the place of the origin of the model on the canvas."""

    scale: float  # points for a length of one
    origin: Array  # (2,)

    def at(self, x: Array) -> Array:
        """Places on the canvas (..., 2) of points in space (..., 3)."""
        return np.asarray(np.round(self.scale * (x @ ISOMETRIC.T) + self.origin, DIGITS))


def fit(x: Array, low: Array, high: Array, room: Box) -> Frame:
    """The largest drawing of points `x` (n, 3) that is in the room with what is drawn about each of them.

    That reaches from `low` (n, 2) to `high` (n, 2) points from its place, whatever the scale.
    """
    flat = x @ ISOMETRIC.T
    start, end = np.array([room.left, room.bottom]), np.array([room.right, room.top])

    def needed(scale: float) -> Array:
        return np.asarray((scale * flat + high).max(axis=0) - (scale * flat + low).min(axis=0))

    size = float(np.ptp(flat, axis=0).max())
    scale = 1.0
    if size:
        least, most = 0.0, float((end - start).max()) / size
        for _ in range(60):
            scale = 0.5 * (least + most)
            least, most = (scale, most) if np.all(needed(scale) <= end - start) else (least, scale)
        scale = least
    middle = 0.5 * ((scale * flat + high).max(axis=0) + (scale * flat + low).min(axis=0))
    return Frame(scale, 0.5 * (start + end) - middle)
