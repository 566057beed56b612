"""Million element-cycles a second, one core, whole cycle with energies: `python benchmarks/elements.py [WORD ...]`.

Each line is a mesh of one element and one law in random motion, beside the same cycle of elastic shells in plain C, so
that the ratio holds on another machine. With words, only lines that contain one of them.
"""

import sys
import time
from collections.abc import Callable

import numpy as np
import plain_c
from meshes import block, chain, moving, sheet

from vmharness.explicit import energy
from vmharness.explicit.force import Elements
from vmharness.explicit.loop import steps
from vmharness.explicit.model.model import Model

REPEATS = 40  # cycles, of which the quickest counts: others use the machine too

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


TRUSS = "*SECTION_BEAM\n1,3\n1.0"
BEAM = "*SECTION_BEAM\n1,2\n1.0,0.1,0.1,0.2"

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
    "truss, elastic": lambda: chain(ELASTIC, TRUSS),
    "truss, plastic bilinear (024)": lambda: chain(BILINEAR, TRUSS),
    "beam Belytschko-Schwer, elastic": lambda: chain(ELASTIC, BEAM),
}


def speed(model: Model, repeats: int = REPEATS) -> float:
    """Million element-cycles a second of the time loop, of the quickest cycle after the first quarter."""
    elements = sum(len(force.eid) for force in model.forces if isinstance(force, Elements))
    cycle, taken = steps(model), []
    for _ in range(repeats):
        began = time.perf_counter()
        state = next(cycle)
        energy.kinetic(state)
        taken.append(time.perf_counter() - began)
    return 1e-6 * elements / min(taken[repeats // 4 :])


if __name__ == "__main__":
    words = sys.argv[1:]
    if found := plain_c.speed(moving(sheet(ELASTIC))):
        print(
            f"{'plain C, shell BT, 3 points, elastic':44}{found[0]:7.2f}   (forces differ by {found[1]:.0e})"
        )
    for name, mesh in LINES.items():
        if not words or any(word in name for word in words):
            print(f"{name:44}{speed(moving(mesh())):7.2f} million element-cycles/s", flush=True)
