"""Progress of running cases, on a terminal only."""

import sys
from collections.abc import Iterable, Iterator, Sequence

from vmharness.execution.message import Began, Message, Progress
from vmharness.suite.outcome import Outcome


def shown(events: Iterable[tuple[int, Message | Outcome]], names: Sequence[str]) -> Iterator[Outcome]:
    """The outcomes among the events of a run; a terminal shows a bar for each case that is being solved."""
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
