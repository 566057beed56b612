"""The yield condition with the plastic strain rate: z = (dp/dt / C)^(1/P) is the unknown, dp = h z^P with h = C dt.

Radial and uniaxial return (K as in consistency.py):

    f(z) = trial - K h z^P - Y(p + h z^P) - (A + B Y(p + h z^P)) z = 0

f is smooth in z, while dp^(1/P) has an infinite slope at dp = 0. It decreases, and is concave where Y is linear, so
that Newton's rule converges to the root from above. It starts at the smaller of the two bounds that the second and the
last term give alone, which is at most twice the root.

Plane stress (plane_stress.py): with lambda = u^P and w = (2 q / 3 h)^(1/P), z = w u; the yield condition is one for u.
Where the viscous part is large, the left side is flat beyond the root, and Newton's rule would leave the interval of
the root, from 0 to the return without rate. The interval is then bisected.
"""

from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.piecewise_linear import Curve, value_and_slope
from vmharness.explicit.materials._plasticity.rate import Viscous

ITERATIONS, HALVINGS = 12, 24
TINY = 1e-300  # avoids 0/0 without stress, or without a step


@inlined
def viscous_increment(trial: float, K: float, p: float, Y: Curve, viscous: Viscous, dt: float) -> float:
    """dp >= 0; 0 where the trial stress is elastic."""
    C, P, A, B = viscous
    h = max(C * dt, TINY)
    y, slope = value_and_slope(Y, p)
    excess = max(trial - y, 0.0)
    z = min(excess / (A + B * y), (excess / (K * h)) ** (1.0 / P))
    for _ in range(ITERATIONS):
        power = z ** (P - 1.0)
        y, slope = value_and_slope(Y, p + h * power * z)
        f = trial - K * h * power * z - y - (A + B * y) * z
        z = max(0.0, z + f / ((K + slope * (1.0 + B * z)) * h * P * power + A + B * y))
    return h * z**P


@inlined
def viscous_multiplier(
    P: float, Q: float, a: float, b: float, p: float, Y: Curve, static: float, viscous: Viscous, dt: float
) -> tuple[float, float]:
    """lambda and dp; `static` is the lambda of the return without rate."""
    C, n, A, B = viscous
    h = max(C * dt, TINY)
    y, slope = value_and_slope(Y, p)
    excess = max((P + Q) ** 0.5 - y, 0.0)
    least, most = 0.0, static ** (1.0 / n)
    u = min(most, excess / ((A + B * y) * (2.0 * y / (3.0 * h)) ** (1.0 / n)))
    for _ in range(HALVINGS):
        power = u ** (n - 1.0)
        x = power * u
        PA, QB = P / (1.0 + a * x) ** 2, Q / (1.0 + b * x) ** 2
        qq = PA + QB + TINY
        q = qq**0.5
        D = a * PA / (1.0 + a * x) + b * QB / (1.0 + b * x)
        kept = (qq - x * D) / qq  # d(lambda q)/d(lambda) / q
        w = (2.0 * q / (3.0 * h)) ** (1.0 / n)
        y, slope = value_and_slope(Y, p + 2.0 / 3.0 * x * q)
        f = q - y - (A + B * y) * w * u
        fall = (D / q + slope * (1.0 + B * w * u) * 2.0 / 3.0 * q * kept) * n * power + (A + B * y) * w * kept
        least, most = (u, most) if f > 0.0 else (least, u)
        newton = u + f / (fall + TINY)
        u = newton if least <= newton <= most else 0.5 * (least + most)
    x = u**n
    return x, 2.0 / 3.0 * x * (P / (1.0 + a * x) ** 2 + Q / (1.0 + b * x) ** 2) ** 0.5
