"""Contact beside the shells that touch: `python benchmarks/contact.py`.

A sheet of side x side shells falls on another, shifted so that its nodes meet the inside of segments; in the second
cycle all of them are in contact. What a cycle costs more than that of the same sheets without contact is its cost.
"""

import time
from collections.abc import Iterator

import numpy as np
from meshes import deck, grid, quadrilaterals, rows

from vmharness.explicit.loop import steps
from vmharness.explicit.model import Model, build

SIDES = (200, 632)  # 40 000 nodes and ten times as many
CYCLES = 40

HEAD = """*PART
lower
         2         1         1
*SECTION_SHELL
         1         2    0.8333         3
       1.0
*MAT_ELASTIC
1,7.8e-6,210.0,0.3
*NODE
"""
CONTACT = """
*CONTACT_NODES_TO_SURFACE
         1         2         3         3


"""


def sheets(side: int, contact: bool) -> Model:
    """Two square sheets of unit shells: part 1, which falls, a thousandth of an edge above part 2."""
    upper, lower = grid(side), grid(side) + (side + 1) ** 2
    lines = [f"{n:8d}{i + 0.3:16.1f}{j + 0.3:16.1f}{1e-3:16.3f}" for (i, j), n in _numbered(upper)]
    lines += [f"{n:8d}{i:16.1f}{j:16.1f}{0.0:16.3f}" for (i, j), n in _numbered(lower)]
    lines += ["*ELEMENT_SHELL", *rows(quadrilaterals(upper)), *rows(quadrilaterals(lower), 2, side**2 + 1)]
    model = build(deck(HEAD + "\n".join(lines) + CONTACT * contact))
    model.state.v[: upper.size, 2] = -20.0
    return model


def _numbered(n: np.ndarray) -> Iterator[tuple[tuple[int, int], int]]:
    return ((place, int(number)) for place, number in np.ndenumerate(n))


def cost(side: int) -> tuple[float, float]:
    """Milliseconds a cycle of contact, and of side x side shells; cycles of both models are taken in turn."""
    cycles = [steps(sheets(side, contact)) for contact in (False, True)]
    taken: list[list[float]] = [[], []]
    for _ in range(CYCLES):
        for cycle, own in zip(cycles, taken, strict=True):
            began = time.perf_counter()
            next(cycle)
            own.append(1e3 * (time.perf_counter() - began))
    without, with_contact = (min(own[CYCLES // 4 :]) for own in taken)
    return with_contact - without, without / 2


if __name__ == "__main__":
    costs = {side: cost(side) for side in SIDES}
    for side, (contact, shells) in costs.items():
        print(
            f"{(side + 1) ** 2:7d} nodes on {side**2:7d} segments {contact:7.2f} ms, as many shells {shells:7.2f} ms"
        )
    print(
        f"ten times the nodes cost {costs[SIDES[1]][0] / costs[SIDES[0]][0]:.1f} times as much (at most 13)"
    )
