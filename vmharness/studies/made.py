"""What made the outcomes of a study."""

from collections.abc import Iterable

from vmharness.studies.maker import Maker
from vmharness.studies.measured import Measured
from vmharness.studies.sources import sources


def maker(outcomes: Iterable[Measured]) -> Maker:
    """The solver as the runs name it, and these sources; no name if every run was lost."""
    return Maker(next((outcome.solver for outcome in outcomes if outcome.solver), ""), sources())
