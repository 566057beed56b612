"""Stiffness damping of a law, for each state of stress: a damped law computes the stress of another law and adds to it.

A damped law has the signature and the constants of that law (materials/_law.py). The history variables of the law are
followed by its stress s_{n-1}, then beta.
"""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from vmharness.explicit.kernels.compiled import specialise, to_be_bound
from vmharness.explicit.kernels.simd import LANES
from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.state import Array

law = to_be_bound("law")
VARIABLES = to_be_bound("VARIABLES")  # history variables of the law


@cache
def damped(around: Callable[..., Any], law: Callable[..., Any], variables: int) -> Callable[..., Any]:
    """Compile a damped law: `around`, a function below, with the `law` and the number of its history `variables`."""
    return specialise(around, law=law, VARIABLES=variables)


def memory(beta: Array, points: int, history: int, stresses: int) -> Array:
    """Initial history (ne, points, variables) of a damped law whose law has `history` variables and `stresses`.

    >>> memory(np.array([0.5]), points=1, history=1, stresses=2)
    array([[[0. , 0. , 0. , 0.5]]])
    """
    kept = np.zeros((beta.size, points, history + stresses + 1))
    kept[..., -1] = beta[:, None]
    return kept


def unload(history: Array, damped: bool) -> None:
    """Set history variables (..., rows * LANES) to those without stress; beta, the last of a `damped` law, is doubled.

    Since s_{n-1} = 0, the stress is then s + 2 beta s/dt: see `Elements.linearised`.
    """
    beta = 2.0 * history[..., -LANES:] if damped else 0.0
    history[:] = 0.0
    if damped:
        history[..., -LANES:] = beta


@inlined
def per_step(beta: float, dt: float) -> float:
    """beta/dt; 0 before the first step, when there is no change of stress."""
    return beta / dt if dt > 0.0 else 0.0


def plane_stress(
    constants: Any, dt: float, dexx: float, deyy: float, dexy: float, deyz: float, dezx: float,
    txx: float, tyy: float, txy: float, tyz: float, tzx: float, history: Array, at: int, stride: int,
) -> tuple[float, float, float, float, float, float]:  # fmt: skip
    """tau = s + beta (s - s_{n-1})/dt, and the strain increment through the thickness of the law."""
    own = at + VARIABLES * stride
    pxx, pyy, pxy = history[own], history[own + stride], history[own + 2 * stride]
    pyz, pzx = history[own + 3 * stride], history[own + 4 * stride]
    rate = per_step(history[own + 5 * stride], dt)
    sxx, syy, sxy, syz, szx, dezz = law(
        constants, dt, dexx, deyy, dexy, deyz, dezx, pxx, pyy, pxy, pyz, pzx, history, at, stride
    )
    history[own], history[own + stride], history[own + 2 * stride] = sxx, syy, sxy
    history[own + 3 * stride], history[own + 4 * stride] = syz, szx
    return (
        sxx + rate * (sxx - pxx), syy + rate * (syy - pyy), sxy + rate * (sxy - pxy),
        syz + rate * (syz - pyz), szx + rate * (szx - pzx), dezz,
    )  # fmt: skip


def solid(
    constants: Any, dt: float, dexx: float, deyy: float, dezz: float, dexy: float, deyz: float, dezx: float,
    txx: float, tyy: float, tzz: float, txy: float, tyz: float, tzx: float,
    history: Array, at: int, stride: int,
) -> tuple[float, float, float, float, float, float]:  # fmt: skip
    """tau = s + beta (s - s_{n-1})/dt."""
    own = at + VARIABLES * stride
    pxx, pyy, pzz = history[own], history[own + stride], history[own + 2 * stride]
    pxy, pyz, pzx = history[own + 3 * stride], history[own + 4 * stride], history[own + 5 * stride]
    rate = per_step(history[own + 6 * stride], dt)
    sxx, syy, szz, sxy, syz, szx = law(
        constants, dt, dexx, deyy, dezz, dexy, deyz, dezx, pxx, pyy, pzz, pxy, pyz, pzx, history, at, stride
    )
    history[own], history[own + stride], history[own + 2 * stride] = sxx, syy, szz
    history[own + 3 * stride], history[own + 4 * stride], history[own + 5 * stride] = sxy, syz, szx
    return (
        sxx + rate * (sxx - pxx), syy + rate * (syy - pyy), szz + rate * (szz - pzz),
        sxy + rate * (sxy - pxy), syz + rate * (syz - pyz), szx + rate * (szx - pzx),
    )  # fmt: skip


def uniaxial(constants: Any, dt: float, deps: float, t: float, history: Array, at: int, stride: int) -> float:
    """tau = s + beta (s - s_{n-1})/dt."""
    own = at + VARIABLES * stride
    past, rate = history[own], per_step(history[own + stride], dt)
    s: float = law(constants, dt, deps, past, history, at, stride)
    history[own] = s
    return s + rate * (s - past)
