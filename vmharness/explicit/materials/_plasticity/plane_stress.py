"""Return to the yield surface in plane stress.

Let eta = sigma - a be the stress less a back stress a with a_zz = 0 and deviator alpha; so da = 2/3 C lambda eta, where
lambda = 3/2 dp / q. Sum and difference of the normal components uncouple. With + for xx + yy, - for xx - yy:

    sigma_+ = trial - lambda E / (3 (1 - nu)) eta_+      eta_+ = trial / (1 + a lambda),   a = E/(3 (1 - nu)) + 2/3 C
    sigma_- = trial - lambda 2 G eta_-                   eta_- = trial / (1 + b lambda),   b = 2 G + 2/3 C

and the shears like the difference. The yield condition is one equation for lambda:

    q^2 = P / (1 + a lambda)^2 + Q / (1 + b lambda)^2 = (r Y(p + 2/3 lambda q))^2
    P = eta_+^2 / 4,   Q = 3/4 eta_-^2 + 3 (eta_xy^2 + eta_yz^2 + eta_zx^2)   of the trial stress

Newton's rule is applied to r Y / q - 1, which is nearly linear in lambda, and concave where Y is: from lambda = 0 it
converges to the root from below. Four steps reach round-off at thirty times the yield stress.
"""

from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.constants import Plastic, modulus
from vmharness.explicit.materials._plasticity.piecewise_linear import Curve, element_curve, value_and_slope
from vmharness.explicit.materials._plasticity.rate import Viscous, factor, viscous_part
from vmharness.explicit.materials._plasticity.viscous import viscous_multiplier
from vmharness.explicit.state import Array

ITERATIONS = 4
TINY = 1e-300  # avoids 0/0 without stress

Shell = tuple[float, float, float, float, float]  # xx, yy, xy, yz, zx


@inlined
def back_stress(C: float | None, history: Array, at: int, stride: int) -> Shell:
    """The components of a, the history variables after p."""
    if C is None:
        return 0.0, 0.0, 0.0, 0.0, 0.0
    return (
        history[at + stride],
        history[at + 2 * stride],
        history[at + 3 * stride],
        history[at + 4 * stride],
        history[at + 5 * stride],
    )


@inlined
def move_back_stress(C: float | None, flow: Shell, history: Array, at: int, stride: int) -> None:
    """da = 2/3 C flow, where flow = lambda eta."""
    if C is not None:
        history[at + stride] += 2 / 3 * C * flow[0]
        history[at + 2 * stride] += 2 / 3 * C * flow[1]
        history[at + 3 * stride] += 2 / 3 * C * flow[2]
        history[at + 4 * stride] += 2 / 3 * C * flow[3]
        history[at + 5 * stride] += 2 / 3 * C * flow[4]


@inlined
def static_multiplier(
    P: float, Q: float, a: float, b: float, p: float, r: float, Y: Curve
) -> tuple[float, float]:
    """lambda and dp.

    With D = a P / (1 + a lambda)^3 + b Q / (1 + b lambda)^3 and H the slope of r Y:
    dq/dlambda = -D/q, and Newton's step is (q - r Y) q^2 / (2/3 H q (q^2 - lambda D) + r Y D).
    """
    x = 0.0
    for _ in range(ITERATIONS):
        A, B = 1 / (1 + a * x), 1 / (1 + b * x)
        PA, QB = P * A * A, Q * B * B
        qq = PA + QB
        q, D = qq**0.5, a * A * PA + b * B * QB
        y, slope = value_and_slope(Y, p + 2 / 3 * x * q)
        x = max(0.0, x + (q - r * y) * qq / (2 / 3 * r * slope * q * (qq - x * D) + r * y * D + TINY))
    A, B = 1 / (1 + a * x), 1 / (1 + b * x)
    return x, 2 / 3 * x * (P * A * A + Q * B * B) ** 0.5


@inlined
def multiplier(
    P: float, Q: float, a: float, b: float, p: float, r: float, Y: Curve, viscous: Viscous | None, dt: float
) -> tuple[float, float]:
    """lambda and dp, by the static or the viscous form; the compiler keeps one of them."""
    x, dp = static_multiplier(P, Q, a, b, p, r, Y)
    if viscous is None:
        return x, dp
    return viscous_multiplier(P, Q, a, b, p, Y, x, viscous, dt)


@inlined
def plane_stress(
    constants: Plastic,
    dt: float,
    dexx: float,
    deyy: float,
    dexy: float,
    deyz: float,
    dezx: float,
    sxx: float,
    syy: float,
    sxy: float,
    syz: float,
    szx: float,
    history: Array,
    at: int,
    stride: int,
) -> tuple[float, float, float, float, float, float]:
    """Stress after a strain increment, with s_zz = 0, and the strain increment through the thickness.

    de_zz = -nu/E (change of s_xx + s_yy) - lambda eta_+ / 3; the rate takes it as -(de_xx + de_yy), as in flow.
    """
    E, nu, C, rate = constants.E, constants.nu, constants.C, constants.rate
    Y = element_curve(constants.Y, at, stride)
    G, bulk, p = E / (2 * (1 + nu)), E / (1 - nu), history[at]
    shears = dexy * dexy + deyz * deyz + dezx * dezx
    r = factor(rate, 4 / 3 * (dexx * dexx + deyy * deyy + dexx * deyy) + shears / 3, dt)

    plus, minus = sxx + syy + bulk * (dexx + deyy), sxx - syy + 2 * G * (dexx - deyy)
    txy, tyz, tzx = sxy + G * dexy, syz + G * deyz, szx + G * dezx
    axx, ayy, axy, ayz, azx = back_stress(C, history, at, stride)
    eta_plus, eta_minus = plus - (axx + ayy), minus - (axx - ayy)
    eta_xy, eta_yz, eta_zx = txy - axy, tyz - ayz, tzx - azx

    P = 0.25 * eta_plus * eta_plus
    Q = 0.75 * eta_minus * eta_minus + 3 * (eta_xy * eta_xy + eta_yz * eta_yz + eta_zx * eta_zx)
    kinematic = 2 / 3 * modulus(C)
    a, b = bulk / 3 + kinematic, 2 * G + kinematic
    x, dp = multiplier(P, Q, a, b, p, r, Y, viscous_part(rate), dt)

    A, B = x / (1 + a * x), x / (1 + b * x)  # lambda eta = A or B times its trial
    new_plus, new_minus = plus - bulk / 3 * A * eta_plus, minus - 2 * G * B * eta_minus
    flow_plus, flow_minus = A * eta_plus, B * eta_minus
    flow = (
        0.5 * (flow_plus + flow_minus),
        0.5 * (flow_plus - flow_minus),
        B * eta_xy,
        B * eta_yz,
        B * eta_zx,
    )
    history[at] = p + dp
    move_back_stress(C, flow, history, at, stride)
    return (
        0.5 * (new_plus + new_minus),
        0.5 * (new_plus - new_minus),
        txy - 2 * G * flow[2],
        tyz - 2 * G * flow[3],
        tzx - 2 * G * flow[4],
        -nu / E * (new_plus - (sxx + syy)) - flow_plus / 3,
    )
