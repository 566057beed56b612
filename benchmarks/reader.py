"""Reading 100 000 nodes and 100 000 shells, and compiling VM-061's kernels: `python benchmarks/reader.py`."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from elements import ELASTIC
from meshes import HEAD, sheet

from vmharness.deck import read, vocabulary

RUN = """
import sys, pathlib, vmharness.case, vmharness.solve, vmharness.backends.builtin as builtin
vmharness.solve.solve(vmharness.case.read(pathlib.Path(sys.argv[1])), builtin)
"""


def reading(side: int = 316) -> float:
    """Seconds to read a deck of side x side shells in fixed format, the best of three."""
    known, taken = vocabulary(), []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "deck.k"
        path.write_text(f"{HEAD}{sheet(ELASTIC, side)}\n*END\n")
        for _ in range(3):
            began = time.perf_counter()
            read(path, known)
            taken.append(time.perf_counter() - began)
    return min(taken)


def first_runs() -> tuple[float, float]:
    """Seconds of the whole process that solves VM-061 with no compiled kernels, and with them (best of three)."""
    case = Path(__file__).parents[1] / "cases" / "VM-061"
    with tempfile.TemporaryDirectory() as cache:
        environment, taken = os.environ | {"VMHARNESS_CACHE": cache}, []
        for _ in range(4):
            began = time.perf_counter()
            subprocess.run([sys.executable, "-c", RUN, case], check=True, env=environment)
            taken.append(time.perf_counter() - began)
    return taken[0], min(taken[1:])


if __name__ == "__main__":
    print(f"100 000 nodes and shells read in {reading():.2f} s")
    print(
        "VM-061 solved in {:.2f} s when its kernels are compiled first, {:.2f} s after".format(*first_runs())
    )
