"""The cases that the arguments of a command select."""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from vmharness.cli.say import complain, say
from vmharness.suite.check import accepted
from vmharness.suite.outcome import Outcome, Status
from vmharness.suite.select import FILE, Entry, SelectError, cases_folder, entries, read_case, select

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


def one(selector: str, cases: Path | None) -> "Case":
    """Read the one case that `selector` selects; raises CaseError, or UsageError if it selects none or several."""
    try:
        found, unknown = select(cases_folder(cases), (selector,))
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    for problem in unknown.values():
        raise click.UsageError(problem)
    if len(found) > 1:
        raise click.UsageError(f"{selector} selects {len(found)} cases; select one")
    return accepted(found[0])


def read_cases(
    found: Sequence[Entry], data: Mapping[str, float], reviewed: bool = True
) -> tuple[list["Case"], list[Outcome]]:
    """The cases with their `data` set, and the outcomes of the cases that are wrong; to be shown, none is `reviewed`.

    Raises UsageError if the events of a case do not happen for these data.
    """
    from vmharness.case import CaseError
    from vmharness.case.settings import RegionError

    cases: list[Case] = []
    broken: list[Outcome] = []
    outside: list[str] = []
    for entry in found:
        try:
            case = accepted(entry) if reviewed else read_case(entry)
            cases.append(_with_data(case, data) if data else case)
        except RegionError as error:
            outside.append(str(error))
        except CaseError as error:
            broken.append(Outcome(entry.id, Status.BROKEN, str(error)))
    if outside:
        raise click.UsageError("--set: " + "\n".join(outside))
    return cases, broken


def _with_data(own: "Case", data: Mapping[str, float]) -> "Case":
    """The case with other data; raises RegionError if its events do not happen for them."""
    from vmharness.case.deck import read_deck
    from vmharness.case.settings import RegionError, with_settings
    from vmharness.deck import DeckError
    from vmharness.review.region import outside

    case = with_settings(own, data)
    with suppress(DeckError):  # the solver says so
        if wrong := outside(case, data, own, read_deck(case)):
            raise RegionError(f"{own.id}: {'; '.join(wrong)}")
    return case
