"""Output of the command line; a closed pipe (`vm list | head -1`) is no error."""

import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.table import Table

    from vmharness.report.blocks import Table as Rows

WIDTH_OF_A_PIPE = 160
RIGHT = {"Target", "Computed", "Value", "Cycles", "Seconds"} | {
    f"{name} (%)" for name in ("Error", "Used", "Tolerance", "Tolerance used", "Budget")
}


def say(text: str) -> None:
    """Print a line to stdout at once; a closed pipe is ignored."""
    try:
        sys.stdout.write(text + "\n")
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(text: str) -> None:
    """Print a line to stderr."""
    sys.stderr.write(f"vm: {text}\n")


def say_table(table: "Table") -> None:
    """Print a table as wide as the terminal, with colours on a terminal only."""
    from rich.console import Console

    console = Console(width=None if sys.stdout.isatty() else WIDTH_OF_A_PIPE)
    with console.capture() as captured:
        console.print(table)
    lines = [line.rstrip() for line in captured.get().splitlines()]
    say("\n".join(["", *filter(None, lines)]))


def say_rows(rows: "Rows") -> None:
    """Print a table of a study as on its page."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Column, Table

    columns = [
        Column(name, justify="right" if number >= rows.numbers else "left", no_wrap=number == 0)
        for number, name in enumerate(rows.head)
    ]
    table = Table(*columns, box=SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False, header_style="bold")
    for row in rows.rows:
        table.add_row(*row)
    say_table(table)


def plain_table(first: str, *others: str) -> "Table":
    """An empty table with a line under its head; its first column is never wrapped."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Column, Table

    columns = [Column(name, justify="right" if name in RIGHT else "left") for name in others]
    head = Column(first, no_wrap=True)
    return Table(head, *columns, box=SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False, header_style="bold")
