"""A variant of a case: what a study runs, and the key under which its outcome is kept."""

import hashlib
import json
from dataclasses import dataclass
from typing import TYPE_CHECKING

from vmharness.backends.calls import identity
from vmharness.studies.sources import sources

if TYPE_CHECKING:
    from vmharness.case import Case


@dataclass(frozen=True)
class Variant:
    """A case to run: with other data (`Case.with_given`), another deck (`Case.with_deck`), or a fault in the solver.

    `fault` names a planted fault of the solver's own, and must be another where that has changed; variants with one
    never share a process with others. `strides`: which samples alone the results are read from, too, every 2nd, ...
    """

    case: "Case"
    label: str = ""
    fault: str = ""
    strides: tuple[int, ...] = ()

    def key(self, solver: str) -> str:
        """A hash of all that the outcome depends on: solver and machine, sources, case, data, deck, fault.

        Raises BackendError where the solver cannot be asked for its version.
        """
        case = self.case
        what = [
            identity(solver),
            sources(solver),
            _files(case),
            dict(case.given),
            case.deck_parameters(),
            case.mesh_parameters(),
            case.deck_text,
            self.fault,
            self.strides,
        ]
        return hashlib.sha256(json.dumps(what, sort_keys=True).encode()).hexdigest()


def _files(case: "Case") -> list[str]:
    """Hashes of the case's files, without prose and pictures, and of those elsewhere that its deck may include."""
    if not case.file.deck.include_outside:
        return [case.inputs_sha256]
    from vmharness.case.deck import read_deck

    return [case.inputs_sha256, *read_deck(case).files.values()]
