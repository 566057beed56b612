"""Components of a solid's stress that a probe shows."""

from collections.abc import Callable

import numpy as np

from vmharness.explicit.kernels.compiled import interpreted
from vmharness.explicit.kernels.rotation import rotation_matrix
from vmharness.explicit.state import Array

COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "zx")
PLACES = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))


def stress_in_space(stress: Array, quaternion: Array) -> Array:
    """Stress (..., points, 6) or (6,) in space, from that in the frames of unit quaternions (..., 4) or (4,).

    >>> stress_in_space(np.array([5.0, 0, 0, 0, 0, 0]), np.array([0.5**0.5, 0, 0, 0.5**0.5])).round(12) + 0.0
    array([0., 5., 0., 0., 0., 0.])
    """
    s, a, b, c = np.moveaxis(quaternion, -1, 0)
    R = np.moveaxis(
        np.array(interpreted(rotation_matrix)(s, (a, b, c))), (0, 1), (-1, -2)
    )  # columns are the axes
    S = np.empty((*stress.shape[:-1], 3, 3))
    for k, (i, j) in enumerate(PLACES):
        S[..., i, j] = S[..., j, i] = stress[..., k]
    if stress.ndim > quaternion.ndim:
        R = R[..., None, :, :]
    rotated = R @ S @ np.swapaxes(R, -1, -2)
    return np.stack([rotated[..., i, j] for i, j in PLACES], axis=-1)


def pressure(s: Array) -> float:
    """-(s_xx + s_yy + s_zz) / 3."""
    return -float(s[:3].sum()) / 3


def von_mises(s: Array) -> float:
    """sqrt(3/2 s' : s')."""
    xx, yy, zz, xy, yz, zx = s
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return float((0.5 * normal + 3 * (xy * xy + yz * yz + zx * zx)) ** 0.5)


def _component(k: int) -> Callable[[Array], float]:
    return lambda s: float(s[k])


CHANNELS: dict[str, Callable[[Array], float]] = {
    **{f"{name}-stress": _component(k) for k, name in enumerate(COMPONENTS)},
    "pressure": pressure,
    "von-mises": von_mises,
}
