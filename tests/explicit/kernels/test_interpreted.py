"""With NUMBA_DISABLE_JIT=1 kernels run as plain Python, for a debugger, and give what the compiled ones give."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]

# The cube of D-43, one solid in simple shear with the Jaumann rate, until it is sheared by 0.08.
SHEAR = """
from pathlib import Path
from vmharness.deck import read, vocabulary
from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

model = build(read(Path("cases/D-43/deck.k"), vocabulary(), parameters={"TEND": 0.004}))
names = "xx-stress", "yy-stress", "xy-stress", "von-mises"
probes = [probe(model, solid=1, component=name) for name in names] + [probe(model, energy="internal")]
for state in steps(model):
    pass
print(state.cycle, *(value() for value in probes))
"""


def shear(**environment):
    """Cycles, stresses and internal energy at the end."""
    env = {**os.environ, "PYTHONPATH": str(ROOT), **environment}
    done = subprocess.run([sys.executable, "-c", SHEAR], env=env, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return [float(word) for word in done.stdout.split()]


def test_a_solid_runs_without_the_compiler():
    interpreted, compiled = shear(NUMBA_DISABLE_JIT="1"), shear()
    assert interpreted[0] == compiled[0] > 20
    assert interpreted[1:] == pytest.approx(compiled[1:], rel=1e-10)
    assert interpreted[3] > 1e9  # s_xy in Pa
