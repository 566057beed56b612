"""Two threads beside one, whole cycle with energies: `python benchmarks/threads.py [WORD ...]`.

Each line is a mesh of benchmarks/elements.py; cycles of both are taken in turn, and the quickest of each counts.
"""

import sys
import time

from elements import LINES, REPEATS
from meshes import moving

from vmharness.explicit import energy
from vmharness.explicit.loop import steps

MESHES = [
    "shell BT, 3 points, elastic",
    "shell BT, 3 points, plastic bilinear (024)",
    "solid one-point, elastic",
    "truss, elastic",
]


def ratio(mesh: str, repeats: int = REPEATS) -> float:
    """How many times as fast two threads are."""
    text = LINES[mesh]()
    cycles = [steps(moving(text)), steps(moving("*CONTROL_PARALLEL\n2\n" + text))]
    taken: list[list[float]] = [[], []]
    for _ in range(repeats):
        for cycle, own in zip(cycles, taken, strict=True):
            began = time.perf_counter()
            energy.kinetic(next(cycle))
            own.append(time.perf_counter() - began)
    one, two = (min(own[repeats // 4 :]) for own in taken)
    return one / two


if __name__ == "__main__":
    words = sys.argv[1:]
    for name in MESHES:
        if not words or any(word in name for word in words):
            print(f"{name:44}{ratio(name):6.2f} times as fast with two threads", flush=True)
