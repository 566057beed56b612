"""A variant of a case: what a study runs, and the key under which its outcome is kept."""

import hashlib
import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import vmharness
from vmharness.case.digest import digest

if TYPE_CHECKING:
    from vmharness.case import Case

APART = {
    "cli",
    "execution",
    "report",
    "studies",
    "suite",
}  # folders that no measured value depends on, but for
MEASURING = {"studies/thinning.py", "studies/measured.py"}  # which make the outcome of a run


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
        """A hash of all that the outcome depends on: case, data, deck, solver, sources, machine, fault."""
        case = self.case
        what = [
            solver,
            sources(),
            _machine(),
            _files(case),
            dict(case.given),
            case.deck_parameters(),
            case.mesh_parameters(),
            case.deck_text,
            self.fault,
            self.strides,
        ]
        return hashlib.sha256(json.dumps(what, sort_keys=True).encode()).hexdigest()


@cache
def sources() -> str:
    """A hash of every source of the package that a measured value may depend on, the same on every machine."""
    package = Path(vmharness.__file__).parent
    paths = (path.relative_to(package) for path in package.rglob("*.py"))
    return digest(package, filter(counts, paths))


def counts(path: Path) -> bool:
    """Whether a measured value may depend on this source of the package.

    >>> counts(Path("measure.py")), counts(Path("studies/measured.py")), counts(Path("studies/sweep/runs.py"))
    (True, True, False)
    """
    return path.parts[0] not in APART or path.as_posix() in MEASURING


@cache
def _machine() -> str:
    """Compiler, processor and planted fault: the last bits of a value depend on them."""
    from vmharness.explicit.kernels.cache import folder

    return folder().name


def _files(case: "Case") -> list[str]:
    """Hashes of the case's files, without prose and pictures, and of those elsewhere that its deck may include."""
    if not case.file.deck.include_outside:
        return [case.inputs_sha256]
    from vmharness.backends.builtin import read_deck

    return [case.inputs_sha256, *read_deck(case).files.values()]
