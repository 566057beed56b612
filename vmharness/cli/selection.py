"""Arguments that select cases, the same for every command."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from vmharness.cli.say import complain, say
from vmharness.suite.select import Entry, SelectError, cases_folder, select

Command = TypeVar("Command", bound=Callable[..., Any])

SELECT = click.argument("selectors", metavar="[SELECT]...", nargs=-1)
CASES = click.option(
    "--cases",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="Folder of case folders.  [default: ./cases, else the installed ones]",
)
WORDS = click.option(
    "-k",
    "words",
    metavar="EXPR",
    default="",
    help="Only cases whose id, title or tags contain these words, with and, or, not between them.",
)
TAGS = click.option(
    "--tag", "tags", metavar="TAG", multiple=True, help="Only cases with this tag; several: with all of them."
)


def selecting(command: Command) -> Command:
    """Add SELECT, --cases, -k and --tag."""
    for option in (TAGS, WORDS, CASES, SELECT):
        command = option(command)
    return command


def selected(
    selectors: tuple[str, ...], cases: Path | None, words: str, tags: tuple[str, ...]
) -> tuple[list[Entry], dict[str, str]]:
    """The cases that are meant, and what is wrong with each selector that means none; says which folder is used."""
    try:
        folder = cases_folder(cases)
        found, unknown = select(folder, selectors, words, tags)
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    say(f"cases: {folder}")
    for problem in unknown.values():
        complain(problem)
    return found, unknown
