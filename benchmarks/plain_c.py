"""The cycle of elastic Belytschko-Tsay shells in plain C (shell.c), compiled by gcc, on the same sheet.

gcc -O3 -march=native -fno-math-errno; one element after the other, no blocks. Its forces are checked against ours.
"""

import ctypes
import math
import subprocess
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from vmharness.explicit.elements.shell.belytschko_tsay import BelytschkoTsay, Hourglass
from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import moduli
from vmharness.explicit.model.model import Model

E, NU, DENSITY, THICKNESS, KAPPA = 210.0, 0.3, 7.8e-6, 1.0, 0.8333


class Section(ctypes.Structure):
    """As in shell.c."""

    _fields_ = (
        ("E", ctypes.c_double),
        ("nu", ctypes.c_double),
        ("thickness", ctypes.c_double),
        ("kappa", ctypes.c_double),
        ("C", ctypes.c_double * 3),
        ("zeta", ctypes.c_double * 3),
        ("weight", ctypes.c_double * 3),
    )


def library() -> ctypes.CDLL | None:
    """shell.c, compiled; None without gcc."""
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "shell.so"
        options = ["-O3", "-march=native", "-fno-math-errno", "-shared", "-fPIC"]
        try:
            subprocess.run(
                ["gcc", *options, "-o", target, Path(__file__).with_name("shell.c"), "-lm"], check=True
            )
        except (OSError, subprocess.CalledProcessError):
            return None
        found = ctypes.CDLL(str(target))
    found.forces.restype = found.advance.restype = ctypes.c_double
    return found


def cycle(c: ctypes.CDLL, model: Model) -> tuple[Callable[[float], float], Callable[[float, float], float]]:
    """Both halves of a cycle on arrays of the model's state: forces(dt) -> L_s, advance(before, dt) -> energy."""
    (shells,) = (force for force in model.forces if isinstance(force, BelytschkoTsay))
    s, corners = model.state, np.ascontiguousarray(shells.nodes, np.int64)
    first = model.x0[corners[:1]]
    C = moduli(first, np.array([THICKNESS]), DENSITY, (E, NU), KAPPA, Hourglass())[:, 0]
    zeta, weight = np.polynomial.legendre.leggauss(3)
    section = Section(E, NU, THICKNESS, KAPPA, tuple(C), tuple(zeta), tuple(weight))
    count, n = len(corners), len(s.x)
    keep = np.zeros((count, 15)), np.zeros((count, 5)), np.zeros(2)
    stress, hourglass, energy = map(pointer, keep)
    x, v, omega, f, moment = map(pointer, (s.x, s.v, s.omega, s.f, s.moment))
    mass, inertia = pointer(s.mass), pointer(s.inertia)

    def forces(dt: float, keep: Any = keep) -> float:  # C knows only where the arrays lie
        return float(
            c.forces(
                ctypes.c_long(count), pointer(corners), x, v, omega, ctypes.c_double(dt), ctypes.byref(section),
                stress, hourglass, f, moment, energy,
            )
        )  # fmt: skip

    def advance(before: float, dt: float) -> float:
        step = ctypes.c_double(before), ctypes.c_double(dt)
        return float(c.advance(ctypes.c_long(n), x, v, omega, f, moment, mass, inertia, *step))

    return forces, advance


def pointer(a: np.ndarray) -> ctypes.c_void_p:
    """Where the numbers of `a` lie."""
    return ctypes.c_void_p(a.ctypes.data)


def check(forces: Callable[[float], float], model: Model, dt: float = 1e-6) -> float:
    """Largest difference between forces and moments of C and ours, over the largest; leaves both cleared."""
    s, found = model.state, []
    s.dt = dt
    for add in (partial(forces, dt), lambda: model.forces[0].add(s)):
        s.f[:] = s.moment[:] = 0.0
        add()
        found.append((s.f.copy(), s.moment.copy()))
    s.f[:] = s.moment[:] = s.dt = 0.0
    return max(float(abs(a - b).max() / abs(b).max()) for a, b in zip(*found, strict=True))


def speed(model: Model, repeats: int = 40) -> tuple[float, float] | None:
    """Million element-cycles a second in C, and the difference of the forces from ours; None without gcc."""
    c = library()
    if c is None:
        return None
    forces, advance = cycle(c, model)
    difference = check(forces, model)
    wave, before, taken = math.sqrt(E / (DENSITY * (1 - NU * NU))), 0.0, []
    for _ in range(repeats):
        began = time.perf_counter()
        dt = 0.9 * forces(before) / wave
        advance(before, dt)
        before = dt
        taken.append(time.perf_counter() - began)
    return 1e-6 * model.forces[0].elements / min(taken), difference
