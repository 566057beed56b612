"""A step with a yield curve of many points: every element of a block sees the next hinges of it only.

A search within the loop over the elements would keep that from vectorising. So each element gets its row of the curve's
table before it, by its plastic strain p. Where p is beyond the row's end afterwards, all is put back, these elements go
on to the row that starts there, and the block does the step again. The result is that of the whole curve: up to its end
a row is the curve, and the left side of the yield condition falls with dp, so that a p beyond the end means that the
root is beyond it.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from vmharness.explicit.kernels.compiled import kernel, specialise
from vmharness.explicit.kernels.simd import LANES
from vmharness.explicit.kernels.vector import inlined, inlined_counted
from vmharness.explicit.materials._plasticity.piecewise_linear import COLUMNS, END, Table, segment
from vmharness.explicit.model.state import Array

if TYPE_CHECKING:

    def once(work: Array, *given: Any) -> None:
        """Not this, but what `with_law` binds."""


Y = 3  # place of the yield curve in the constants of the laws


def looks_ahead(constants: tuple[Any, ...]) -> bool:
    """Whether the constants of a law hold a yield curve of many points."""
    return len(constants) > Y and isinstance(constants[Y], tuple) and constants[Y][1] is not None


def with_law(update: Callable[..., Any], law: Callable[..., Any], ahead: bool) -> Callable[..., Any]:
    """Compile `update`, a loop over the elements of a block that calls the `law`.

    Its first argument is the work buffer, its last are constants, stress and history; `ahead` as in `looks_ahead`.
    """
    once = specialise(update, law=law)
    return specialise(step_ahead, once=once) if ahead else once


def step_ahead(work: Array, *given: Any) -> None:
    """`once` with the rows of the curve's table that the elements need."""
    constants, stress, history = given[-3:]
    table = constants[Y][1]
    begin(table, history)
    keep(table, work, stress, history)
    once(work, *given[:-3], by_rows(constants), stress, history)
    while go_on(table, history):
        put_back(table, work, stress, history)
        once(work, *given[:-3], by_rows(constants), stress, history)


@inlined_counted
def by_rows(constants: Any) -> Any:
    """The constants with the rows of the elements in place of the table."""
    hinges, table, _ = constants[Y]
    seen = hinges, None, table[3]
    return (*constants[:3], seen, *constants[4:])  # numbers, since compiled slices of tuples want them


@inlined
def look(table: Table, e: int, p: float) -> None:
    """Give element e the row that starts at or before p."""
    rows, near, k = table[2], table[3], segment(table, p)
    for column in range(COLUMNS):
        near[column * LANES + e] = rows[k, column]


@kernel
def begin(table: Table, history: Array) -> None:
    """Give the elements the rows of their plastic strain, the first of the history variables."""
    for e in range(LANES):
        look(table, e, history[e])


@kernel
def go_on(table: Table, history: Array) -> bool:
    """Give those whose plastic strain is beyond the end of their row the row from there on; whether there are any."""
    near, passed = table[3], 0
    for e in range(LANES):
        passed += 1 if history[e] > near[END * LANES + e] else 0
    if passed == 0:
        return False
    for e in range(LANES):
        if history[e] > near[END * LANES + e]:
            look(table, e, near[END * LANES + e])
    return True


@kernel
def keep(table: Table, work: Array, stress: Array, history: Array) -> None:
    """Copy what a step changes."""
    kept, a, b = table[4], work.size, work.size + stress.size
    for i in range(work.size):
        kept[i] = work[i]
    for i in range(stress.size):
        kept[a + i] = stress[i]
    for i in range(history.size):
        kept[b + i] = history[i]


@kernel
def put_back(table: Table, work: Array, stress: Array, history: Array) -> None:
    """The way back."""
    kept, a, b = table[4], work.size, work.size + stress.size
    for i in range(work.size):
        work[i] = kept[i]
    for i in range(stress.size):
        stress[i] = kept[a + i]
    for i in range(history.size):
        history[i] = kept[b + i]
