"""Elements computed by several threads: the same mechanics, and the same bits run after run."""

import numpy as np
import pytest

from vmharness.explicit import energy
from vmharness.explicit.build import build
from vmharness.explicit.force import Elements
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe
from vmharness.explicit.threads import FEWEST, ThreadPool, divided

SIDE = 50  # cells of a sheet of quadrilaterals, of which one row is cut in triangles
PARALLEL = "*CONTROL_PARALLEL\n{ncpu}\n"
HEAD = """*KEYWORD
*CONTROL_TERMINATION
1.0
*PART
sheet
1,1,1
*SECTION_SHELL
1,2,1.0,2
0.1
*MAT_ELASTIC
1,1.0,100.0,0.3
"""


def sheet():
    """*NODE and *ELEMENT_SHELL of the sheet."""
    n = np.arange(1, (SIDE + 1) ** 2 + 1).reshape(SIDE + 1, SIDE + 1)
    lines = ["*NODE"]
    lines += [f"{n[i, j]},{i}.0,{j}.0,0.0" for i in range(SIDE + 1) for j in range(SIDE + 1)]
    lines += ["*ELEMENT_SHELL"]
    element = 0
    for i in range(SIDE):
        for j in range(SIDE):
            a, b, c, d = n[i, j], n[i + 1, j], n[i + 1, j + 1], n[i, j + 1]
            for corners in ((a, b, c, c), (a, c, d, d)) if i == 0 else ((a, b, c, d),):
                element += 1
                lines.append(",".join(map(str, (element, 1, *corners))))
    return "\n".join(lines) + "\n"


def wobbling(deck, ncpu):
    """The model, each node with a velocity of its own."""
    model = build(deck(HEAD + PARALLEL.format(ncpu=ncpu) + sheet()))
    model.state.v[:] = np.random.default_rng(1).normal(size=model.x0.shape)
    return model


def after(model, cycles=20):
    """The state after some cycles, and the energies."""
    for state in steps(model):
        if state.cycle == cycles:
            break
    return state, [energy.kinetic(state), sum(a.item() for a in energy.stored(model.forces))]


def test_threads_change_nothing_but_round_off(deck):
    one, alone = after(wobbling(deck, 1))
    two, together = after(wobbling(deck, 2))
    assert two.t == pytest.approx(one.t, rel=1e-14)
    np.testing.assert_allclose(two.x, one.x, rtol=0, atol=1e-12)
    np.testing.assert_allclose(two.omega, one.omega, rtol=0, atol=1e-11 * abs(one.omega).max())
    np.testing.assert_allclose(together, alone, rtol=1e-12)


@pytest.mark.parametrize("ncpu", [1, 2, 3])
def test_the_same_bits_run_after_run(deck, ncpu):
    runs = [after(wobbling(deck, ncpu))[0].x.tobytes() for _ in range(2)]
    assert runs[0] == runs[1]


def test_a_large_part_is_shared_and_its_elements_are_still_found(deck):
    model = wobbling(deck, 2)
    blocks = [force for force in model.forces if isinstance(force, Elements)]
    assert len(blocks) == 3, "two shares of the quadrilaterals, one of the triangles: they are few"
    every = np.concatenate([block.eid for block in blocks])
    assert sorted(every) == list(range(1, SIDE * SIDE + SIDE + 1))
    last = probe(model, shell=int(every.max()), component="xx-stress")
    for state in steps(model):
        if state.cycle == 3:
            break
    assert last() != 0.0


def test_each_thread_has_about_the_same_number_of_elements(deck):
    model = wobbling(deck, 2)
    loads = [sum(force.eid.size for force in forces) for forces in divided(model.forces, 2)]
    assert abs(loads[0] - loads[1]) < FEWEST


def test_what_a_thread_raises_is_raised(deck):
    model = wobbling(deck, 2)

    def fail(state):
        raise FloatingPointError("in a thread")

    threads = ThreadPool(model.forces, model.state, 2)
    threads.others[0][0][0].add = fail
    with pytest.raises(FloatingPointError, match="in a thread"):
        threads.add_forces()
