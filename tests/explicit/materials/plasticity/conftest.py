"""The three laws as functions of a strain path, and the rate equations that they integrate."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.materials._plasticity import plane_stress, solid, uniaxial

E, NU, SIGY = 210.0, 0.3, 0.3


@kernel
def solid_path(constants, dt, increments, history, stress):
    """Stress (steps + 1, 6) after increments (steps, 6)."""
    for n in range(len(increments)):
        d, s = increments[n], stress[n]
        after = solid.solid(
            constants, dt, d[0], d[1], d[2], d[3], d[4], d[5],
            s[0], s[1], s[2], s[3], s[4], s[5], history, 0, 1,
        )  # fmt: skip
        for k in range(6):
            stress[n + 1, k] = after[k]


@kernel
def plane_path(constants, dt, increments, history, stress, thickness):
    """Stress (steps + 1, 5) and thickness strain (steps + 1,) after increments (steps, 5)."""
    for n in range(len(increments)):
        d, s = increments[n], stress[n]
        after = plane_stress.plane_stress(
            constants, dt, d[0], d[1], d[2], d[3], d[4], s[0], s[1], s[2], s[3], s[4], history, 0, 1
        )
        for k in range(5):
            stress[n + 1, k] = after[k]
        thickness[n + 1] = thickness[n] + after[5]


@kernel
def uniaxial_path(constants, dt, increments, history, stress):
    """Stress (steps + 1,) after increments (steps,)."""
    for n in range(len(increments)):
        stress[n + 1] = uniaxial.uniaxial(constants, dt, increments[n], stress[n], history, 0, 1)


def run(law, constants, increments, dt=1.0):
    """Stresses along a path from rest, the history at its end, and the thickness strains in plane stress."""
    steps, history = len(increments), np.zeros(7)
    if law == "uniaxial":
        stress = np.zeros(steps + 1)
        uniaxial_path(constants, dt, increments, history, stress)
        return stress, history
    stress = np.zeros((steps + 1, increments.shape[1]))
    if law == "solid":
        solid_path(constants, dt, increments, history, stress)
        return stress, history
    thickness = np.zeros(steps + 1)
    plane_path(constants, dt, increments, history, stress, thickness)
    return stress, history, thickness


# The rate equations, in components xx, yy, zz, and xy, yz, zx times sqrt(2), so that a : b is a plain product.
ROOT2 = np.array([1, 1, 1, np.sqrt(2), np.sqrt(2), np.sqrt(2)])
ONE = np.array([1.0, 1, 1, 0, 0, 0])
DEVIATOR = np.eye(6) - np.outer(ONE, ONE) / 3
HOOKE = E / (1 + NU) * DEVIATOR + E / (1 - 2 * NU) * np.outer(ONE, ONE) / 3


def flow(sigma, alpha):
    """q and d(eps_p)/dp."""
    xi = DEVIATOR @ sigma - alpha
    q = np.sqrt(1.5 * xi @ xi)
    return q, 1.5 * xi / q


def follow(tangent, d, free):
    """Strain rate with the components `free` such that their stress rate vanishes."""
    d = d.copy()
    given = [k for k in range(6) if k not in free]
    if free:
        d[free] = -np.linalg.solve(tangent[np.ix_(free, free)], tangent[np.ix_(free, given)] @ d[given])
    return d


def leg(y, d, H, C, free):
    """y = (sigma, alpha, p, strain), (19,), after one unit of time at the strain rate d: elastic, then on the surface."""
    sigma, alpha, p, strain = y[:6], y[6:12], y[12], y[13:]
    elastic = follow(HOOKE, d, free)
    ds = HOOKE @ elastic
    a, b = DEVIATOR @ ds, DEVIATOR @ sigma - alpha
    roots = np.roots([1.5 * a @ a, 3 * a @ b, 1.5 * b @ b - (SIGY + H * p) ** 2])  # q(t) = Y
    at = min(1.0, max(roots.real))
    start = np.concatenate([sigma + at * ds, alpha, [p], strain + at * elastic])

    def rate(t, y):
        _, n = flow(y[:6], y[6:12])
        Cn = HOOKE @ n
        tangent = HOOKE - np.outer(Cn, Cn) / (n @ Cn + H + C)
        whole = follow(tangent, d, free)
        dp = Cn @ whole / (n @ Cn + H + C)
        return np.concatenate([tangent @ whole, 2 / 3 * C * dp * n, [dp], whole])

    if at == 1.0:
        return start
    return solve_ivp(rate, (at, 1.0), start, method="DOP853", rtol=1e-11, atol=1e-13).y[:, -1]


def integrate(legs, H, C, free=()):
    """(sigma, alpha, p, strain) after strain increments (n, 6), tensor components, each at a constant rate."""
    y = np.zeros(19)
    for d in legs:
        y = leg(y, d * ROOT2, H, C, list(free))
    return y[:6] / ROOT2, y[6:12] / ROOT2, y[12], y[13:] / ROOT2


@pytest.fixture(scope="session")
def laws() -> SimpleNamespace:
    """The functions above."""
    return SimpleNamespace(E=E, NU=NU, SIGY=SIGY, run=run, integrate=integrate)
