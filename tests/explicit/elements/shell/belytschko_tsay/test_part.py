"""A block is the sum of its elements, the same bits every time, compiled or not; and what it refuses."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

RUN = """
import json
import numpy as np
from vmharness.explicit.elements.shell.belytschko_tsay import BelytschkoTsay, Hourglass
from vmharness.explicit.materials import Moduli
from vmharness.explicit.materials.elastic import Elastic, plane_stress
from vmharness.explicit.state import State

RNG = np.random.default_rng(5)
X = np.array([(i, j, 0.0) for i in range(4) for j in range(4)]) + 0.2 * RNG.uniform(-1, 1, (16, 3))
V, OMEGA = RNG.normal(size=(2, 16, 3))
N = np.arange(16).reshape(4, 4)
NODES = np.stack([N[:-1, :-1], N[1:, :-1], N[1:, 1:], N[:-1, 1:]], axis=-1).reshape(-1, 4)
THICKNESS = 0.1 + 0.01 * np.arange(9)


def run(which, ihq=4, isdo=0):
    # forces, moments, energies, stress and stable step of some of the elements after five steps
    elastic = (plane_stress, Elastic(7.0, 0.3), Moduli(7.0, 0.3))
    block = BelytschkoTsay("", NODES[which], X, THICKNESS[which], 1.0, *elastic, 3, 5 / 6, Hourglass(ihq), isdo)
    state = State(X.copy(), V, OMEGA, np.ones(16), np.ones(16))
    for _ in range(5):
        state.f[:], state.moment[:] = 0.0, 0.0
        block.add(state)
        state.dt = 1e-3
        state.x += state.dt * V
    energies = [block.energy["internal"][0], block.energy["hourglass"][0]]
    return np.concatenate([state.f.ravel(), state.moment.ravel(), energies]), block.stress, block.stable_step()
"""
SCRIPT = (
    RUN
    + "print(json.dumps([[a.tolist(), s.tolist(), d] for a, s, d in (run([0, 4], 4, 0), run([0, 4], 2, 2))]))"
)
space: dict = {}
exec(RUN, space)
run = space["run"]


@pytest.mark.parametrize("count", [1, 7, 8, 9])
def test_block_is_the_sum_of_its_elements(count):
    sums, stress, step = run(list(range(count)))
    single = [run([e]) for e in range(count)]
    assert sums == pytest.approx(sum(one[0] for one in single), rel=1e-13, abs=1e-15)
    assert np.array_equal(stress, np.concatenate([one[1] for one in single]))
    assert step == min(one[2] for one in single)
    assert np.abs(stress).min(axis=(1, 2)).max() > 0


def test_same_bits_every_time():
    first, second = run(list(range(9))), run(list(range(9)))
    assert all(np.array_equal(a, b) for a, b in zip(first, second, strict=True))


def test_plain_python_gives_the_same():
    """With NUMBA_DISABLE_JIT=1 the kernels are the functions as written."""
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT], env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    for plain, compiled in zip(json.loads(done.stdout), (run([0, 4], 4, 0), run([0, 4], 2, 2)), strict=True):
        for a, b in zip(plain, compiled, strict=True):
            assert np.array(a) == pytest.approx(b, rel=1e-12, abs=1e-14)


def test_stress_can_be_given(bench):
    x, nodes = bench.rectangles(3, 3, 1.0, 1.0)
    block = bench.shells(x, nodes, 0.1, nip=4)
    stress = np.random.default_rng(1).normal(size=(9, 4, 5))
    block.stress = stress
    assert np.array_equal(block.stress, stress)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"nip": 0}, "NIP = 0: 1 to 10"),
        ({"nip": 11}, "NIP = 11: 1 to 10"),
        ({"isdo": 3}, "ISDO = 3: 0, 1 and 2"),
        ({"nodes": [[0, 2, 3, 1], [0, 1, 3, 3]]}, "shell 1 has a node twice"),
        ({"nodes": [[0, 3, 2, 1]]}, "shell 0 has no area"),
        ({"t": 0.0}, "shell 0 has no thickness"),
        ({"t": float("nan")}, "shell 0 has no thickness"),
    ],
)
def test_what_it_refuses(bench, change, message):
    x, _ = bench.rectangles(1, 1, 1.0, 1.0)
    given = {"nodes": [[0, 2, 3, 1]], "t": 0.1, **change}
    with pytest.raises(ValueError, match=message):
        bench.shells(x, np.array(given.pop("nodes")), **given)
