"""Million element-cycles a second, one core, whole cycle with energies: `python benchmarks/elements.py [WORD ...]`.

Each line is a mesh of one element and one law in random motion, beside a plain C loop of known work, so that
the ratio holds on another machine. With words, only lines that contain one of them.
"""

import ctypes
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np

from vmharness.backends.builtin import FOLDERS
from vmharness.deck import read, vocabulary
from vmharness.explicit import energy
from vmharness.explicit.loop import steps
from vmharness.explicit.model import build

SIDE = 200  # shells along each side of the sheet
REPEATS = 40  # cycles, of which the median counts

ELASTIC = "*MAT_ELASTIC\n1,7.8e-6,210.0,0.3\n"
BILINEAR = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-6,210.0,0.3,0.3,2.0\n\n\n\n"
POINTS = (
    "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-6,210.0,0.3\n\n"
    "0.,.01,.02,.04,.08,.16,.3,.6\n.3,.35,.38,.42,.46,.49,.51,.52\n"
)
LONG = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-6,210.0,0.3\n,,1\n\n\n*DEFINE_CURVE\n1\n" + "\n".join(
    f"{p:.3f},{0.3 + 0.2 * p**0.5:.6f}" for p in np.linspace(0, 1, 100)
)
KINEMATIC = "*MAT_PLASTIC_KINEMATIC\n1,7.8e-6,210.0,0.3,0.3,2.0,0.5\n\n"
RATE = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-6,210.0,0.3,0.3,2.0\n40.0,5.0\n\n\n"


def sheet(material: str) -> str:
    """200 x 200 Belytschko-Tsay shells of three points; a random velocity of each node takes them beyond yield."""
    n = np.arange(1, (SIDE + 1) ** 2 + 1).reshape(SIDE + 1, SIDE + 1)
    x = np.indices(n.shape).reshape(2, -1).T
    v = np.random.default_rng(1).normal(size=(n.size, 3)) * 20.0
    corners = np.stack([n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]], axis=-1).reshape(-1, 4)
    return "\n".join([
        "*SECTION_SHELL\n1,2,0.8333,3\n1.0",
        "*NODE", *(f"{i},{a}.0,{b}.0,0.0" for i, (a, b) in enumerate(x.tolist(), 1)),
        "*ELEMENT_SHELL", *(f"{i},1,{a},{b},{c},{d}" for i, (a, b, c, d) in enumerate(corners.tolist(), 1)),
        "*INITIAL_VELOCITY_NODE", *(f"{i},{a:.3f},{b:.3f},{c:.3f}" for i, (a, b, c) in enumerate(v.tolist(), 1)),
        material,
    ])  # fmt: skip


def block(material: str, elform: int = 1) -> str:
    """34 x 34 x 34 hexahedra."""
    n = np.arange(1, 35**3 + 1).reshape(35, 35, 35)
    x = np.indices(n.shape).reshape(3, -1).T
    v = np.random.default_rng(1).normal(size=(n.size, 3)) * 20.0
    low, high = slice(None, -1), slice(1, None)
    square = ((low, low), (high, low), (high, high), (low, high))
    corners = np.stack([n[i, j, k] for k in (low, high) for i, j in square], axis=-1).reshape(-1, 8)
    return "\n".join([
        f"*SECTION_SOLID\n1,{elform}",
        "*NODE", *(f"{i},{a}.0,{b}.0,{c}.0" for i, (a, b, c) in enumerate(x.tolist(), 1)),
        "*ELEMENT_SOLID", *(f"{i},1\n" + ",".join(map(str, row)) for i, row in enumerate(corners.tolist(), 1)),
        "*INITIAL_VELOCITY_NODE", *(f"{i},{a:.3f},{b:.3f},{c:.3f}" for i, (a, b, c) in enumerate(v.tolist(), 1)),
        material,
    ])  # fmt: skip


def chain(material: str) -> str:
    """40 000 trusses in a row."""
    count = SIDE**2
    v = np.random.default_rng(1).normal(size=count + 1) * 20.0
    return "\n".join([
        "*SECTION_BEAM\n1,3\n1.0",
        "*NODE", *(f"{i},{i}.0,0.0,0.0" for i in range(1, count + 2)),
        "*ELEMENT_BEAM", *(f"{i},1,{i},{i + 1}" for i in range(1, count + 1)),
        "*INITIAL_VELOCITY_NODE", *(f"{i},{a:.3f}" for i, a in enumerate(v.tolist(), 1)),
        material,
    ])  # fmt: skip


LINES: dict[str, Callable[[], str]] = {
    "shell BT, 3 points, elastic": lambda: sheet(ELASTIC),
    "shell BT, 3 points, plastic bilinear (024)": lambda: sheet(BILINEAR),
    "shell BT, 3 points, plastic 8 points (024)": lambda: sheet(POINTS),
    "shell BT, 3 points, plastic 100 points (024)": lambda: sheet(LONG),
    "shell BT, 3 points, plastic mixed (003)": lambda: sheet(KINEMATIC),
    "shell BT, 3 points, plastic with rate (024)": lambda: sheet(RATE),
    "solid one-point, elastic": lambda: block(ELASTIC),
    "solid one-point, plastic bilinear (024)": lambda: block(BILINEAR),
    "solid one-point, plastic mixed (003)": lambda: block(KINEMATIC),
    "solid fully integrated, elastic": lambda: block(ELASTIC, 2),
    "truss, elastic": lambda: chain(ELASTIC),
    "truss, plastic bilinear (024)": lambda: chain(BILINEAR),
}


def speed(deck: str) -> float:
    """Million element-cycles a second of the time loop."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "deck.k"
        path.write_text(f"*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*PART\np\n1,1,1\n{deck}\n*END\n")
        model = build(read(path, vocabulary(*FOLDERS)))
    elements = sum(getattr(force, "elements", 0) for force in model.forces)
    cycle, taken = steps(model), []
    for _ in range(REPEATS):
        began = time.perf_counter()
        state = next(cycle)
        energy.kinetic(state)
        taken.append(time.perf_counter() - began)
    return 1e-6 * elements / median(taken[REPEATS // 4 :])


C = """
/* a += b c over vectors that stay in cache: multiply-adds, n times */
double work(double *a, const double *b, const double *c, long m, long n) {
    for (long k = 0; k < n; k++) for (long i = 0; i < m; i++) a[i] += b[i] * c[i];
    return a[0];
}
"""


def plain_c() -> float | None:
    """Thousand million multiply-adds a second of a loop that gcc vectorises; None without gcc."""
    with tempfile.TemporaryDirectory() as folder:
        source, library = Path(folder) / "work.c", Path(folder) / "work.so"
        source.write_text(C)
        try:
            subprocess.run(
                ["gcc", "-O3", "-march=native", "-shared", "-fPIC", "-o", library, source], check=True
            )
        except (OSError, subprocess.CalledProcessError):
            return None
        work = ctypes.CDLL(str(library)).work
    work.restype = ctypes.c_double
    m, n = 1024, 200_000
    a, b, c = np.zeros(m), np.ones(m), np.ones(m)
    pointers = [x.ctypes.data_as(ctypes.c_void_p) for x in (a, b, c)]
    taken = []
    for _ in range(5):
        began = time.perf_counter()
        work(*pointers, ctypes.c_long(m), ctypes.c_long(n))
        taken.append(time.perf_counter() - began)
    return 1e-9 * m * n / min(taken)


if __name__ == "__main__":
    words = sys.argv[1:]
    reference = plain_c()
    print(f"plain C loop: {reference:.2f} 1e9 multiply-adds/s" if reference else "no gcc: no reference")
    for name, deck in LINES.items():
        if not words or any(word in name for word in words):
            text = deck()
            print(f"{name:44}{speed(text):7.2f} million element-cycles/s", flush=True)
