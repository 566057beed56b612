"""A step with a yield curve of many points: each element of a block has the next few hinges of the curve only.

A search within the loop over the elements would prevent its vectorisation. Each element therefore takes one row of the
table of the curve, selected by its plastic strain p before the step. If p is beyond the end of the row after the step,
the block is restored, these elements take the row that starts where theirs ends, and the block repeats the step. The
result is that of the whole curve: a row is the curve up to its end, and the left side of the yield condition falls with
dp, so that a p beyond the end means that the root is beyond it.
"""

from collections.abc import Callable
from typing import Any

from vmharness.explicit.kernels.compiled import kernel, specialise, to_be_bound
from vmharness.explicit.kernels.simd import LANES
from vmharness.explicit.kernels.vector import inlined, inlined_counted
from vmharness.explicit.materials._plasticity.constants import Plastic
from vmharness.explicit.materials._plasticity.piecewise_linear import COLUMNS, END, Table, is_long, segment
from vmharness.explicit.state import Array

one_step: Callable[..., None] = to_be_bound("one_step")


def has_long_curve(constants: tuple[Any, ...]) -> bool:
    """Whether these are constants of plasticity with a yield curve of many points."""
    return isinstance(constants, Plastic) and is_long(constants.Y)


def with_law(update: Callable[..., Any], law: Callable[..., Any], long_curve: bool) -> Callable[..., Any]:
    """Compile `update`, a loop over the elements of a block that calls the `law`.

    Its first argument is the work buffer, its last are constants, stress and history; `long_curve` as in
    `has_long_curve`.
    """
    one_step = specialise(update, law=law)
    return specialise(step_by_rows, one_step=one_step) if long_curve else one_step


def step_by_rows(work: Array, *given: Any) -> None:
    """One step of a block with the rows of the curve's table that its elements need."""
    constants, stress, history = given[-3:]
    table = constants.Y[1]
    select_rows(table, history)
    save(table, work, stress, history)
    one_step(work, *given[:-3], by_rows(constants), stress, history)
    while advance_rows(table, history):
        restore(table, work, stress, history)
        one_step(work, *given[:-3], by_rows(constants), stress, history)


@inlined_counted
def by_rows(constants: Any) -> Any:
    """The constants with the rows of the elements in place of the table."""
    hinges, table, _ = constants.Y
    return Plastic(constants.E, constants.nu, constants.C, (hinges, None, table[3]), constants.rate)


@inlined
def select_row(table: Table, e: int, p: float) -> None:
    """Give element e the row that starts at or before p."""
    rows, selected, k = table[2], table[3], segment(table, p)
    for column in range(COLUMNS):
        selected[column * LANES + e] = rows[k, column]


@kernel
def select_rows(table: Table, history: Array) -> None:
    """Give each element the row of its plastic strain, which is the first of the history variables."""
    for e in range(LANES):
        select_row(table, e, history[e])


@kernel
def advance_rows(table: Table, history: Array) -> bool:
    """Give each element whose plastic strain is beyond its row the next row; return whether there was one."""
    selected, passed = table[3], 0
    for e in range(LANES):
        passed += 1 if history[e] > selected[END * LANES + e] else 0
    if passed == 0:
        return False
    for e in range(LANES):
        if history[e] > selected[END * LANES + e]:
            select_row(table, e, selected[END * LANES + e])
    return True


@kernel
def save(table: Table, work: Array, stress: Array, history: Array) -> None:
    """Copy what a step changes."""
    saved, a, b = table[4], work.size, work.size + stress.size
    for i in range(work.size):
        saved[i] = work[i]
    for i in range(stress.size):
        saved[a + i] = stress[i]
    for i in range(history.size):
        saved[b + i] = history[i]


@kernel
def restore(table: Table, work: Array, stress: Array, history: Array) -> None:
    """Undo a step."""
    saved, a, b = table[4], work.size, work.size + stress.size
    for i in range(work.size):
        work[i] = saved[i]
    for i in range(stress.size):
        stress[i] = saved[a + i]
    for i in range(history.size):
        history[i] = saved[b + i]
