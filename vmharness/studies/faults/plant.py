"""Planting of a fault: when a process imports the module, one exact text of its source is replaced.

The process must be new: what it has imported is sound. A kernel with the fault in it, at any depth, has a cache of its
own, since it computes something else (explicit/kernels/meaning.py).
"""

import sys
from collections.abc import Sequence
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType

from vmharness.studies.faults.planted import FAULTS
from vmharness.studies.faults.solver_fault import PlantError, SolverFault


def faults() -> list[SolverFault]:
    """All faults, by kind and name."""
    return sorted(FAULTS, key=lambda one: (one.kind, one.name))


def fault(name: str) -> SolverFault:
    """The fault of that name; raises PlantError where there is none."""
    if found := next((one for one in FAULTS if one.name == name), None):
        return found
    raise PlantError(f"no fault {name}; there are: {', '.join(sorted(one.name for one in FAULTS))}")


def plant(digest: str) -> None:
    """Make this process import the faulty module of the fault with this digest.

    Raises PlantError where that is too late, or the fault is another by now.
    """
    chosen = fault(digest.rpartition("-")[0])
    if chosen.digest != digest:
        raise PlantError(f"{chosen.name}: its texts have changed since it was chosen")
    chosen.planted(source_of(chosen.module))
    if chosen.module in sys.modules:
        raise PlantError(f"{chosen.name}: {chosen.module} is imported already: plant it in a new process")
    sys.meta_path.insert(0, _Finder(chosen))


def source_of(module: str) -> str:
    """The source of a module of this package; nothing is imported for it."""
    path = Path(__file__).parents[2].joinpath(*module.split(".")[1:])
    file = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    try:
        return file.read_text(encoding="utf-8")
    except OSError as error:
        raise PlantError(f"{module} cannot be read: {error.strerror}") from None


class _Finder(MetaPathFinder):
    """Import finder of the faulty module only."""

    def __init__(self, fault: SolverFault) -> None:
        self.fault = fault

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        if fullname != self.fault.module:
            return None
        spec = PathFinder.find_spec(fullname, path, target)
        if spec is None or spec.origin is None:
            raise PlantError(f"{self.fault.name}: no source of {fullname} is found")
        spec.loader = _Loader(fullname, spec.origin, self.fault)
        return spec


class _Loader(SourceFileLoader):
    def __init__(self, fullname: str, path: str, fault: SolverFault) -> None:
        super().__init__(fullname, path)
        self.fault = fault

    def get_code(self, fullname: str) -> CodeType:
        """Compile the faulty source; the cached byte code is that of the sound source, and none is written."""
        source = self.fault.planted(self.get_data(self.path).decode("utf-8"))
        code: CodeType = compile(source, self.path, "exec", dont_inherit=True)
        return code
