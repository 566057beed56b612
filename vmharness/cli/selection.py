"""Cases selected by the arguments of a command, and read."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from vmharness.cli.say import complain, say
from vmharness.suite.outcome import Outcome, Status
from vmharness.suite.select import Entry, SelectError, cases_folder, select

if TYPE_CHECKING:
    from vmharness.case import Case

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


def one(selector: str, cases: Path | None) -> "Case":
    """The case that `selector` names, read; raises CaseError, or UsageError where it means none or several."""
    from vmharness.case import read

    try:
        found, unknown = select(cases_folder(cases), (selector,))
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    for problem in unknown.values():
        raise click.UsageError(problem)
    if len(found) > 1:
        raise click.UsageError(f"{selector} means {len(found)} cases; name one")
    return read(found[0].folder)


def read_cases(found: Sequence[Entry], data: Mapping[str, float]) -> tuple[list["Case"], list[Outcome]]:
    """The cases with their `data` set, and the outcomes of those that cannot be read or set."""
    from vmharness.case import CaseError, read
    from vmharness.case.settings import with_settings

    cases: list[Case] = []
    broken: list[Outcome] = []
    for entry in found:
        try:
            case = read(entry.folder)
            cases.append(with_settings(case, data) if data else case)
        except CaseError as error:
            broken.append(Outcome(entry.id, Status.BROKEN, str(error)))
    return cases, broken
