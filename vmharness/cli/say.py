"""Output: lines to whoever reads, also when that one has gone (`vm list | head -1`)."""

import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.table import Table

WIDTH_OF_A_PIPE = 160


def say(text: str) -> None:
    """Print to stdout, at once; once the reader has closed the pipe, to nobody."""
    try:
        sys.stdout.write(text + "\n")
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(text: str) -> None:
    """Print to stderr."""
    sys.stderr.write(f"vm: {text}\n")


def say_table(table: "Table") -> None:
    """Print a table, as wide as the terminal; colour is for a terminal only."""
    from rich.console import Console

    console = Console(width=None if sys.stdout.isatty() else WIDTH_OF_A_PIPE)
    with console.capture() as captured:
        console.print(table)
    say("\n".join(line.rstrip() for line in captured.get().splitlines()))


def plain_table(*columns: str) -> "Table":
    """A table with a line under its head, and no other."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    return Table(*columns, box=SIMPLE_HEAD, pad_edge=False, header_style="bold")
