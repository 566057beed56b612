"""Mass, centre and inertia of rigid bodies."""

from dataclasses import dataclass

import numpy as np

from vmharness.deck import Entry
from vmharness.explicit.state import Array

ROUND_OFF = 1e-12  # of the largest: a smaller principal moment is zero, as that of a line of points
DIGITS = 1e-4  # of the largest: a field of ten columns may hold no more than five digits of a number


@dataclass(frozen=True)
class Inertia:
    """Mass, centre (3,) and inertia tensor about it (3, 3), in space; consistent units."""

    mass: float
    centre: Array
    tensor: Array


def inertia_of_points(x: Array, mass: Array, rotary: Array) -> Inertia:
    """Mass, centre and inertia of points `x` (m, 3) with `mass` (m,) and `rotary` inertia (m,) about every axis.

    I = sum m (r^2 E - r r^T) + J E,   r = x - c
    """
    total = float(mass.sum())
    centre = mass @ x / total
    r = x - centre
    square = float(mass @ np.einsum("ij,ij->i", r, r) + rotary.sum())
    return Inertia(total, centre, square * np.eye(3) - (mass[:, None] * r).T @ r)


def inertia_of_card(entry: Entry, centre: Array) -> Inertia:
    """Mass and inertia that *PART_INERTIA or *CONSTRAINED_NODAL_RIGID_BODY_INERTIA give, IRCS = 1 rotated to space.

    The local axes are e1 along XL, YL, ZL, e3 along e1 x (XLIP, YLIP, ZLIP), e2 = e3 x e1. Products of inertia are
    components of the tensor: IXY = -int x y dm. Raises DeckError where axes or tensor cannot be: of the principal
    moments I1 <= I2 <= I3 none is negative, and I3 = int r1^2 + r2^2 dm <= I1 + I2, which a flat body reaches.
    """
    xx, xy, xz, yy, yz, zz = (getattr(entry, name) for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if entry.ircs == 1:
        axes = _local_axes(entry)
        tensor = axes @ tensor @ axes.T
    _check_moments(entry, np.linalg.eigvalsh(tensor))
    return Inertia(entry.tm, centre, tensor)


def _check_moments(entry: Entry, moments: Array) -> None:
    """Principal moments (3,), in increasing order, are possible for a body, within the digits of a card."""
    given, allowed = ", ".join(f"{moment:.6g}" for moment in moments), DIGITS * np.abs(moments).max()
    if moments[0] < -allowed:
        raise entry.error("ixx", f"no body has principal moments {given}: the first is negative")
    if moments[2] > moments[0] + moments[1] + allowed:
        raise entry.error(
            "ixx", f"no body has principal moments {given}: the last exceeds the sum of the others"
        )


def lever_arms(inertia: Inertia, x: Array) -> Array:
    """Distances (m,) of points `x` (m, 3) from the line, or point, about which the body has no inertia; 0 without one.

    A force at such a distance has a moment that no inertia resists: the equation of motion has no solution.
    """
    moments, axes = principal_axes(inertia.tensor)
    r = (x - inertia.centre) @ axes
    without = moments == 0.0
    if not without.any():
        return np.zeros(len(x))
    return np.asarray(np.linalg.norm(r if without.all() else r[:, ~without], axis=1))


def _local_axes(entry: Entry) -> Array:
    """e1, e2, e3 as columns (3, 3)."""
    first = np.array([entry.xl, entry.yl, entry.zl])
    normal = np.cross(first, [entry.xlip, entry.ylip, entry.zlip])
    if not np.linalg.norm(normal) > 0.0:
        raise entry.error("xl", "the local axes need two vectors that are not parallel")
    e1, e3 = first / np.linalg.norm(first), normal / np.linalg.norm(normal)
    return np.column_stack([e1, np.cross(e3, e1), e3])


def principal_axes(tensor: Array) -> tuple[Array, Array]:
    """Principal moments (3,) and a right-handed triad of principal axes, as columns (3, 3).

    A tensor that is diagonal already has the axes x, y, z.
    """
    size = np.abs(tensor).max()
    if np.abs(tensor - np.diag(np.diag(tensor))).max() <= ROUND_OFF * size:
        moments, axes = np.diag(tensor).copy(), np.eye(3)
    else:
        moments, axes = np.linalg.eigh(tensor)
        axes[:, 2] = np.cross(axes[:, 0], axes[:, 1])
    moments[moments <= ROUND_OFF * size] = 0.0
    return moments, axes


def quaternion(axes: Array) -> Array:
    """The unit quaternion (4,) of a rotation matrix (3, 3), by the largest of its components (Shepperd 1978)."""
    m, trace = axes, np.trace(axes)
    squares = np.array([1.0 + trace, *(1.0 + 2.0 * m[i, i] - trace for i in range(3))])  # 4 q_i^2
    largest = int(np.argmax(squares))
    products = np.array([
        [squares[0], m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]],
        [m[2, 1] - m[1, 2], squares[1], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0]],
        [m[0, 2] - m[2, 0], m[0, 1] + m[1, 0], squares[2], m[1, 2] + m[2, 1]],
        [m[1, 0] - m[0, 1], m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], squares[3]],
    ])  # fmt: skip
    q = products[largest] / (2.0 * np.sqrt(squares[largest]))
    return np.asarray(q / np.linalg.norm(q))
