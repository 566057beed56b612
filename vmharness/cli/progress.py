"""Progress bars, on a terminal only."""

import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from typing import Protocol

from vmharness.execution.message import Began, Message, Progress
from vmharness.suite.outcome import Outcome


def case_bars(events: Iterable[tuple[int, Message | Outcome]], names: Sequence[str]) -> Iterator[Outcome]:
    """Yield the outcomes among the events of a run; a terminal shows a bar for each case in the solver."""
    if not sys.stdout.isatty():
        yield from (event for _, event in events if isinstance(event, Outcome))
        return
    from rich.progress import BarColumn, TaskID, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bars

    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.percentage:3.0f} %"))
    tasks: dict[int, TaskID] = {}
    with Bars(*columns, TimeElapsedColumn(), transient=True) as bars:
        for number, event in events:
            match event:
                case Began():
                    tasks[number] = bars.add_task(names[number], total=1.0)
                case Progress(fraction):
                    bars.update(tasks[number], completed=fraction)
                case Outcome():
                    bars.remove_task(tasks[number])
                    yield event


class Advance(Protocol):
    """Set the fraction of a variant that is done."""

    def __call__(self, number: int, fraction: float) -> None: ...


@contextmanager
def study_bar(study: str, count: int) -> Iterator[Advance]:
    """One bar for all variants of a study; yields the function that advances it."""
    if not sys.stdout.isatty():
        yield lambda number, fraction: None
        return
    from rich.progress import BarColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bars

    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.completed:.1f} of {task.total}"),
    )
    fractions: dict[int, float] = {}
    with Bars(*columns, TimeElapsedColumn(), transient=True) as bars:
        task = bars.add_task(study, total=count)

        def advance(number: int, fraction: float) -> None:
            fractions[number] = fraction
            bars.update(task, completed=sum(fractions.values()))

        yield advance
