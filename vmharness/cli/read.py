"""Selected cases, read and checked; a broken one is an outcome, and stops no other."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vmharness.case.settings import with_settings
from vmharness.suite.outcome import Outcome, Status
from vmharness.suite.select import Entry

if TYPE_CHECKING:
    from vmharness.case import Case


def read_cases(found: Sequence[Entry], data: Mapping[str, float]) -> tuple[list["Case"], list[Outcome]]:
    """The cases with their `data` set, and the outcomes of those that cannot be read or set."""
    from vmharness.case import CaseError, read

    cases: list[Case] = []
    broken: list[Outcome] = []
    for entry in found:
        try:
            case = read(entry.folder)
            cases.append(with_settings(case, data) if data else case)
        except CaseError as error:
            broken.append(Outcome(entry.id, Status.BROKEN, str(error)))
    return cases, broken
