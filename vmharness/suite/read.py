"""Cases read in a process beside the command: whatever one of them does, or how long it takes, is its own outcome."""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING

from vmharness.execution.call import called, calling
from vmharness.execution.message import Done, Lost
from vmharness.execution.pool import Pool
from vmharness.suite.check import accepted
from vmharness.suite.outcome import Outcome, Status
from vmharness.suite.select import Entry, read_case

if TYPE_CHECKING:
    from vmharness.case import Case
    from vmharness.case.settings import RegionError

READING = 60.0  # seconds: no case takes longer to read
NEEDED = (  # modules for reading and review, which are no work of a case
    "vmharness.case.deck",
    "vmharness.report.prose",
    "vmharness.review.deck_values",
    "vmharness.review.own_input",
    "vmharness.review.region",
    "vmharness.studies.faults.declared",
    "scipy.interpolate",
    "scipy.optimize",
)


def reader() -> Pool:
    """The process in which cases are read; a context."""
    return Pool(1, calling, *NEEDED)


def read_cases(
    pool: Pool, found: Sequence[Entry], data: Mapping[str, float], timeout: float, reviewed: bool = True
) -> tuple[list["Case"], list[Outcome]]:
    """The cases with their `data` set, and the outcomes of the cases that are wrong; to be shown, none is `reviewed`.

    Raises RegionError if the events of a case do not happen for these data.
    """
    from vmharness.case.settings import RegionError

    cases: list[Case] = []
    broken: list[Outcome] = []
    outside: list[str] = []
    calls = [partial(_read, entry, data, reviewed) for entry in found]
    for number, end in called(pool, calls, min(timeout, READING)):
        match end:
            case Done(Outcome() as outcome):
                broken.append(outcome)
            case Done(RegionError() as error):
                outside.append(str(error))
            case Done(case):
                cases.append(case)
            case Lost(reason):
                broken.append(_broken(found[number], reason))
            case _:
                broken.append(_broken(found[number], end.error))
    if outside:
        raise RegionError("\n".join(outside))
    return cases, broken


def _read(entry: Entry, data: Mapping[str, float], reviewed: bool) -> "Case | Outcome | RegionError":
    """In a worker: read a case and set its data; or what is wrong with it."""
    from vmharness.case import CaseError
    from vmharness.case.settings import RegionError

    try:
        case = accepted(entry) if reviewed else read_case(entry)
        return _with_data(case, data) if data else case
    except RegionError as error:
        return error
    except CaseError as error:
        return Outcome(entry.id, Status.BROKEN, str(error))
    except Exception as error:  # whatever else one case does
        return _broken(entry, f"{type(error).__name__}: {error}")


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


def _broken(entry: Entry, reason: str) -> Outcome:
    return Outcome(entry.id, Status.BROKEN, f"{entry.id}: cannot be read: {reason}")
