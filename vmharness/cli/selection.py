"""The cases that the arguments of a command select."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from vmharness.cli.say import complain, say
from vmharness.suite.outcome import Outcome
from vmharness.suite.read import read_cases, reader
from vmharness.suite.select import FILE, Entry, SelectError, cases_folder, entries, select

if TYPE_CHECKING:
    from vmharness.case import Case

Command = TypeVar("Command", bound=Callable[..., Any])

SELECT = click.argument("selectors", metavar="[SELECT]...", nargs=-1)
CASES = click.option(
    "--cases",
    type=click.Path(path_type=Path),
    metavar="DIR",
    help="Folder that contains the case folders.  [default: ./cases, else the installed ones]",
)
WORDS = click.option(
    "-k",
    "words",
    metavar="EXPR",
    default="",
    help="Only cases whose id, title or tags contain these words; join words with and, or, not.",
)
TAGS = click.option(
    "--tag",
    "tags",
    metavar="TAG",
    multiple=True,
    help="Only cases with this tag; repeat the option: all these tags.",
)


def selecting(command: Command) -> Command:
    """Add SELECT, --cases, -k and --tag."""
    for option in (TAGS, WORDS, CASES, SELECT):
        command = option(command)
    return command


def selected(
    selectors: tuple[str, ...], cases: Path | None, words: str, tags: tuple[str, ...]
) -> tuple[list[Entry], dict[str, str]]:
    """The selected cases, and a message for each selector that selects none; prints the folder of the cases.

    Says so if the folder has no case at all.
    """
    try:
        folder = cases_folder(cases)
        found, unknown = select(folder, selectors, words, tags)
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    say(f"cases: {folder}")
    if not found and not entries(folder):
        complain(f"no case in {folder.resolve()}: none of its folders has a {FILE}")
    for problem in unknown.values():
        complain(problem)
    return found, unknown


def one(selector: str, cases: Path | None, timeout: float) -> "Case":
    """Read the one case that `selector` selects; raises CaseError, or UsageError if it selects none or several."""
    from vmharness.case import CaseError

    try:
        found, unknown = select(cases_folder(cases), (selector,))
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    for problem in unknown.values():
        raise click.UsageError(problem)
    if len(found) > 1:
        raise click.UsageError(f"{selector} selects {len(found)} cases; select one")
    read, broken = read_apart(found, timeout)
    for outcome in broken:
        raise CaseError(outcome.reason)
    return read[0]


def read_apart(
    found: Sequence[Entry], timeout: float, reviewed: bool = True
) -> tuple[list["Case"], list[Outcome]]:
    """The cases, read in another process within `timeout` seconds each, and the outcomes of those that are wrong."""
    with reader() as pool:
        return read_cases(pool, found, {}, timeout, reviewed)
