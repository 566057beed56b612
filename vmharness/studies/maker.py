"""The solver and sources that made the record of a study: the record is stale once they have changed."""

from collections.abc import Iterable
from dataclasses import dataclass

from vmharness.studies.measured import Measured
from vmharness.studies.sources import sources


@dataclass(frozen=True)
class Maker:
    """The solver and the sources of the measured values of a record, independent of the machine."""

    solver: str  # name and version, as its runs say them
    sources: str  # sha256


def maker(outcomes: Iterable[Measured]) -> Maker:
    """The solver as its runs name it, and the present sources; no name if every run was lost."""
    return Maker(next((outcome.solver for outcome in outcomes if outcome.solver), ""), sources())
