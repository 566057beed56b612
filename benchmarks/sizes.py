"""Time per element-cycle and peak memory of sheets of 1 000 to 1 000 000 elastic shells: `python benchmarks/sizes.py`.

Each size is a process of its own, which reads and builds the model from a deck text; that text is in its memory too.
"""

import resource
import subprocess
import sys

from elements import ELASTIC, speed
from meshes import moving, sheet

SIDES = (32, 100, 316, 1000)


def one(side: int) -> tuple[int, float, float]:
    """Shells, nanoseconds per element-cycle, gigabytes."""
    model = moving(sheet(ELASTIC, side))
    rate = speed(model, max(12, min(400, 4_000_000 // side**2)))
    return side**2, 1e3 / rate, 1e-6 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def figures() -> list[tuple[int, float, float]]:
    """Of all sizes."""
    found = []
    for side in SIDES:
        run = [sys.executable, __file__, str(side)]
        shells, ns, memory = subprocess.run(run, check=True, capture_output=True, text=True).stdout.split()
        found.append((int(shells), float(ns), float(memory)))
    return found


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print(*one(int(sys.argv[1])))
    else:
        for shells, ns, memory in figures():
            print(f"{shells:9d} shells {ns:7.1f} ns per element-cycle {memory:6.2f} GB at most", flush=True)
