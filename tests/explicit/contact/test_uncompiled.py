"""A contact with friction runs as plain Python with NUMBA_DISABLE_JIT=1, to the same numbers up to round-off."""

import json
import os
import subprocess
import sys

import pytest

# A ball on four corners: it falls aslant on a shell, sticks, slips and leaves.
RUN = """
import json, sys
from pathlib import Path
from vmharness.deck import read, vocabulary
from vmharness.explicit.build import build
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe
model = build(read(Path(sys.argv[1]), vocabulary()))
names = ("x-force", "z-force", "energy", "friction energy", "nodes")
show = [probe(model, contact=1, component=name) for name in names]
print(json.dumps([[s.t, *s.x[4], *s.v[4], *(value() for value in show)] for s in steps(model)]))
"""
DECK = """*KEYWORD
*CONTROL_TERMINATION
0.6
*CONTROL_TIMESTEP
,,,,,7
*DEFINE_CURVE
7
0.0,0.01
1.0,0.01
*PART
wall
1,1,1
*SECTION_SHELL
1,2,1.0,2
0.1
*MAT_ELASTIC
1,1e-4,3.0,0.0
*ELEMENT_SHELL
1,1,1,2,3,4
*NODE
1,-1.0,-1.0,0.0,7,7
2,1.0,-1.0,0.0,7,7
3,1.0,1.0,0.0,7,7
4,-1.0,1.0,0.0,7,7
5,0.1,0.2,0.005
*ELEMENT_MASS
105,5,0.01
*INITIAL_VELOCITY_NODE
5,0.5,0.0,-1.0
*SET_NODE_LIST
2
5
*CONTROL_CONTACT
1.0

*CONTACT_NODES_TO_SURFACE
2,1,4,3
0.3,0.2,1.0,,10.0

"""


@pytest.fixture
def history(tmp_path):
    """What a process of its own prints, with warnings as errors."""
    deck = tmp_path / "deck.k"
    deck.write_text(DECK)

    def of(**environment):
        done = subprocess.run(
            [sys.executable, "-W", "error", "-c", RUN, str(deck)],
            env={**os.environ, **environment},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    return of


def test_plain_python_gives_what_the_compiled_kernels_give(history):
    compiled, plain = history(), history(NUMBA_DISABLE_JIT="1")
    assert len(plain) == len(compiled) > 50
    for row, other in zip(plain, compiled, strict=True):
        assert row == pytest.approx(other, rel=1e-9, abs=1e-12)
    _, *_, friction, _ = plain[-1]
    touching = [row[-1] for row in plain]
    assert touching[0] == touching[-1] == 0
    assert 1 in touching
    assert friction > 0.0
