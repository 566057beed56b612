"""Return in uniaxial stress: |eta_trial| - (E + C) dp = r Y(p + dp), eta = s - a, with da = C dp sign(eta)."""

from math import copysign

from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.consistency import increment
from vmharness.explicit.materials._plasticity.constants import Plastic, modulus
from vmharness.explicit.materials._plasticity.piecewise_linear import element_curve
from vmharness.explicit.materials._plasticity.rate import factor, viscous_part
from vmharness.explicit.state import Array


@inlined
def back_stress(C: float | None, history: Array, at: int, stride: int) -> float:
    """a = 3/2 alpha_xx, the history variable after p."""
    if C is None:
        return 0.0
    return history[at + stride]


@inlined
def move_back_stress(C: float | None, de_p: float, history: Array, at: int, stride: int) -> None:
    """da = C d(eps_p)."""
    if C is not None:
        history[at + stride] += C * de_p


@inlined
def uniaxial(
    constants: Plastic,
    dt: float,
    deps: float,
    s: float,
    history: Array,
    at: int,
    stride: int,
) -> float:
    """Axial stress after a strain increment."""
    E, C, rate = constants.E, constants.C, constants.rate
    Y = element_curve(constants.Y, at, stride)
    p, trial = history[at], s + E * deps
    eta = trial - back_stress(C, history, at, stride)
    r = factor(rate, deps * deps, dt)
    dp = increment(abs(eta), E + modulus(C), p, r, Y, viscous_part(rate), dt)
    de_p = copysign(dp, eta)
    history[at] = p + dp
    move_back_stress(C, de_p, history, at, stride)
    return trial - E * de_p
