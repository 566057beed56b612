"""What made the record of a study, so that an auditor can tell whether it still would be the same."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Maker:
    """The solver and the sources that the measured values of a record come from, whatever the machine."""

    solver: str  # name and version, as its runs say them
    sources: str  # sha256
