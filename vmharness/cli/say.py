"""Output of the command line; a closed pipe (`vm list | head -1`) is no error.

A file named `-` is standard output: what else there is to say then goes to standard error.
"""

import os
import shutil
import sys
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from rich.table import Table

    from vmharness.report.blocks import Table as Rows

WIDTH_OF_A_PIPE = 160
LABEL = 10  # columns of the first column, at least
RIGHT = {"Target", "Computed", "Value", "Cycles", "Seconds"} | {
    f"{name} (%)" for name in ("Error", "Used", "Tolerance", "Tolerance used", "Budget")
}


STDOUT = Path("-")
TAKEN = "vmharness.stdout"  # in the context of the command, if a file is written there


class File(click.Path):
    """A file to write, or `-` for standard output."""

    def __init__(self) -> None:
        super().__init__(dir_okay=False, allow_dash=True, path_type=Path)

    def convert(self, value: Any, parameter: click.Parameter | None, context: click.Context | None) -> Any:
        """The path; of `-` the context remembers that standard output is taken."""
        path = super().convert(value, parameter, context)
        if path == STDOUT and context is not None:
            context.meta[TAKEN] = True
        return path


def write_file(path: Path, text: str) -> None:
    """Write a file for machines; raises OSError."""
    from vmharness.execution import atomic

    if path == STDOUT:
        _print(text, sys.stdout)
    else:
        atomic.write(path, text)


def say(text: str) -> None:
    """Print a line at once, without control characters; a closed pipe is ignored."""
    _print(without_controls(text) + "\n", _stream())


def complain(text: str) -> None:
    """Print a line to stderr, without control characters."""
    sys.stderr.write(f"vm: {without_controls(text)}\n")


def without_controls(text: str) -> str:
    """The text without the characters that control a terminal: a title of a deck could move its cursor or clear it.

    >>> without_controls("a\\x1b[2Jb\\tc")
    'a[2Jb\\tc'
    """
    return "".join(one for one in text if one in "\n\t" or one.isprintable())


def say_table(table: "Table") -> None:
    """Print a table as wide as the terminal, with colours on a terminal only."""
    from rich.console import Console

    stream = _stream()
    console = Console(file=stream, width=width(), markup=False, emoji=False)  # [x] and :x: are texts of cases
    with console.capture() as captured:
        console.print(table)
    lines = [line.rstrip() for line in captured.get().splitlines()]
    _print("\n".join(["", *filter(None, lines)]) + "\n", stream)


def width() -> int:
    """Columns of the terminal; many where there is none."""
    return shutil.get_terminal_size().columns if _stream().isatty() else WIDTH_OF_A_PIPE


def _stream() -> IO[str]:
    """Standard output, or standard error where a file is written to standard output."""
    context = click.get_current_context(silent=True)
    return sys.stderr if context is not None and context.meta.get(TAKEN) else sys.stdout


def _print(text: str, stream: IO[str]) -> None:
    try:
        stream.write(text)
        stream.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


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
        table.add_row(*map(without_controls, row))
    say_table(table)


def plain_table(first: str, *others: str) -> "Table":
    """An empty table with a line under its head; numbers are never cut, the first column is wrapped to make room."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Column, Table

    columns = [
        Column(name, justify="right" if name in RIGHT else "left", no_wrap=name in RIGHT) for name in others
    ]
    head = Column(first, overflow="fold", min_width=LABEL)

    class Plain(Table):
        """Its texts have no control characters."""

        def add_row(self, *cells: Any, **options: Any) -> None:
            super().add_row(*(without_controls(c) if isinstance(c, str) else c for c in cells), **options)

    return Plain(head, *columns, box=SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False, header_style="bold")
