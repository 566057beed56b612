"""Contact beside the shells that touch: `python benchmarks/contact.py`.

A sheet of side x side shells is pressed on another, shifted so that its nodes meet the inside of segments; the penalty
is soft, so that they stay in contact. Its cost is what a cycle costs more than one of the same sheets without contact:
the median of cycles in which more than 99 % of the nodes touch, and of sorting, shared out over all cycles. Times are
the processor's, so that what else runs on the machine counts little.
"""

import time
from collections.abc import Iterator
from statistics import median
from typing import NamedTuple

import numpy as np
from meshes import deck, grid, quadrilaterals, rows

from vmharness.explicit.build import build
from vmharness.explicit.contact.contact import Contact
from vmharness.explicit.loop import steps
from vmharness.explicit.model.model import Model

SIDES = (200, 632)  # 40 000 nodes and ten times as many
CYCLES = 100  # less than half a swing on the penalty's spring
TOUCHING = 0.99  # of the nodes

HEAD = """*CONTROL_CONTACT
0.001

*PART
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


class Cost(NamedTuple):
    """Milliseconds a cycle."""

    touching: float  # of nodes in contact
    sorting: float  # one sort, over the cycles that it serves
    shells: float  # as many as there are segments

    @property
    def contact(self) -> float:
        """All of it."""
        return self.touching + self.sorting


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


def cost(side: int) -> Cost:
    """Of side x side nodes on segments; cycles with and without contact are taken in turn."""
    models = [sheets(side, contact) for contact in (False, True)]
    cycles = [steps(model) for model in models]
    (contact,) = (force for force in models[1].forces if isinstance(force, Contact))
    for cycle in cycles:
        next(cycle)  # compiles
    parameters, without, held = contact.passes[0].parameters, [], []
    for count in range(1, CYCLES + 1):
        bare, full = (milliseconds(cycle) for cycle in cycles)
        without.append(bare)
        if parameters["travel"] == 0.0:
            sort = full
        elif contact.nodes_in_contact() > TOUCHING * (side + 1) ** 2:
            held.append(full)
        if count == CYCLES // 2:
            serves = count * float(parameters["margin"][0] / parameters["travel"][0])  # cycles between sorts
            parameters["margin"] = -1.0  # so that the next one sorts
    plain, with_contact = median(without), median(held)
    return Cost(with_contact - plain, (sort - with_contact) / serves, plain / 2)


def milliseconds(cycle: Iterator[object]) -> float:
    """Processor time of one cycle."""
    began = time.thread_time()
    next(cycle)
    return 1e3 * (time.thread_time() - began)


if __name__ == "__main__":
    costs = {side: cost(side) for side in SIDES}
    for side, c in costs.items():
        print(
            f"{(side + 1) ** 2} nodes on {side**2} segments: {c.contact:.2f} ms a cycle, {c.sorting:.2f} for sorting"
        )
        print(f"as many shells: {c.shells:.2f} ms; ratio {c.contact / c.shells:.2f} (at most 1)")
    small, large = (costs[side].contact for side in SIDES)
    print(f"ten times the nodes cost {large / small:.1f} times as much (at most 13)")
