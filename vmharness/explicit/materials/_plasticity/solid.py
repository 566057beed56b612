"""Radial return: the flow direction xi / q of the end of the step is that of the trial stress.

xi_trial = s_trial - alpha,   q_trial - (3 G + C) dp = r Y(p + dp)
s = s_trial - 3 G dp xi / q,   d(alpha) = C dp xi / q;   the pressure is elastic
"""

from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.consistency import increment
from vmharness.explicit.materials._plasticity.constants import Plastic, modulus
from vmharness.explicit.materials._plasticity.piecewise_linear import element_curve
from vmharness.explicit.materials._plasticity.rate import factor, viscous_part
from vmharness.explicit.state import Array

TINY = 1e-300  # avoids 0/0 without stress

Tensor = tuple[float, float, float, float, float, float]  # xx, yy, zz, xy, yz, zx


@inlined
def back_stress(C: float | None, history: Array, at: int, stride: int) -> Tensor:
    """alpha, the history variables after p."""
    if C is None:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    return (
        history[at + stride],
        history[at + 2 * stride],
        history[at + 3 * stride],
        history[at + 4 * stride],
        history[at + 5 * stride],
        history[at + 6 * stride],
    )


@inlined
def move_back_stress(C: float | None, flow: float, xi: Tensor, history: Array, at: int, stride: int) -> None:
    """d(alpha) = C flow xi, where flow = dp / q."""
    if C is not None:
        history[at + stride] += C * flow * xi[0]
        history[at + 2 * stride] += C * flow * xi[1]
        history[at + 3 * stride] += C * flow * xi[2]
        history[at + 4 * stride] += C * flow * xi[3]
        history[at + 5 * stride] += C * flow * xi[4]
        history[at + 6 * stride] += C * flow * xi[5]


@inlined
def squared_norm(a: Tensor) -> float:
    """a : a of a symmetric tensor."""
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + 2 * (a[3] * a[3] + a[4] * a[4] + a[5] * a[5])


@inlined
def solid(
    constants: Plastic,
    dt: float,
    dexx: float,
    deyy: float,
    dezz: float,
    dexy: float,
    deyz: float,
    dezx: float,
    sxx: float,
    syy: float,
    szz: float,
    sxy: float,
    syz: float,
    szx: float,
    history: Array,
    at: int,
    stride: int,
) -> Tensor:
    """Stress xx, yy, zz, xy, yz, zx after a strain increment (engineering shears)."""
    E, nu, C, rate = constants.E, constants.nu, constants.C, constants.rate
    Y = element_curve(constants.Y, at, stride)
    G, p = E / (2 * (1 + nu)), history[at]
    mean = (dexx + deyy + dezz) / 3
    de = (dexx - mean, deyy - mean, dezz - mean, 0.5 * dexy, 0.5 * deyz, 0.5 * dezx)
    pressure = (sxx + syy + szz) / 3
    volume = E / (1 - 2 * nu) * mean

    s0 = sxx - pressure + 2 * G * de[0]
    s1 = syy - pressure + 2 * G * de[1]
    s2 = szz - pressure + 2 * G * de[2]
    s3, s4, s5 = sxy + 2 * G * de[3], syz + 2 * G * de[4], szx + 2 * G * de[5]
    back = back_stress(C, history, at, stride)
    xi = (s0 - back[0], s1 - back[1], s2 - back[2], s3 - back[3], s4 - back[4], s5 - back[5])
    q = (1.5 * squared_norm(xi)) ** 0.5
    r = factor(rate, 2 / 3 * squared_norm(de), dt)
    dp = increment(q, 3 * G + modulus(C), p, r, Y, viscous_part(rate), dt)

    flow = dp / (q + TINY)
    fall = 3 * G * flow
    history[at] = p + dp
    move_back_stress(C, flow, xi, history, at, stride)
    return (
        s0 - fall * xi[0] + pressure + volume,
        s1 - fall * xi[1] + pressure + volume,
        s2 - fall * xi[2] + pressure + volume,
        s3 - fall * xi[3],
        s4 - fall * xi[4],
        s5 - fall * xi[5],
    )
