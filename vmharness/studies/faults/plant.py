"""Plant a fault: one exact text of one module stands replaced when a process imports it. Neither module knows.

The process must be new: what it has imported is sound. A kernel with the fault in it, at any depth, has a cache of its
own, since it computes something else (explicit/kernels/meaning.py).
"""

import hashlib
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType

from vmharness import plugins

FOLDER = "vmharness.studies.faults.planted"


class PlantError(Exception):
    """A fault that cannot be planted: it is unknown, its text is no longer there, or its module is imported."""


@dataclass(frozen=True)
class Plant:
    """A fault of a module: where it stands, the sound text and the faulty one."""

    name: str  # of its file
    text: str  # what is wrong, in words
    kind: str  # physics, integration, or reading
    module: str
    sound: str
    faulty: str
    keywords: tuple[str, ...] = ()  # a deck without a keyword that begins with one of these cannot show it

    @property
    def digest(self) -> str:
        """Tells this fault, with its texts, from every other."""
        content = "\0".join((self.name, self.module, self.sound, self.faulty))
        return f"{self.name}-{hashlib.sha256(content.encode()).hexdigest()[:16]}"

    def planted(self, source: str) -> str:
        """The `source` of its module with the fault in it; PlantError unless the sound text is there just once."""
        if (found := source.count(self.sound)) != 1:
            times = f"{found} times" if found else "nowhere"
            raise PlantError(
                f"{self.name}: {self.sound!r} stands {times} in {self.module}: bring the fault up to date"
            )
        return source.replace(self.sound, self.faulty)


def names() -> list[str]:
    """The faults that there are: the files of the folder."""
    return plugins.names(FOLDER)


def fault(name: str) -> Plant:
    """The fault of that name; raises PlantError where there is none."""
    if name not in names():
        raise PlantError(f"no fault {name}; there are: {', '.join(names())}")
    return of_module(plugins.module(FOLDER, name))


def faults() -> list[Plant]:
    """All of them, by kind and name."""
    return sorted((fault(name) for name in names()), key=lambda one: (one.kind, one.name))


def of_module(module: ModuleType) -> Plant:
    """The fault that a module of the folder describes: the first line of its docstring says what is wrong."""
    return Plant(
        name=module.__name__.rpartition(".")[2],
        text=(module.__doc__ or "").strip().splitlines()[0].rstrip("."),
        kind=module.KIND,
        module=module.MODULE,
        sound=module.SOUND,
        faulty=module.FAULTY,
        keywords=getattr(module, "KEYWORDS", ()),
    )


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
    """Finds the faulty module, and no other."""

    def __init__(self, fault: Plant) -> None:
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
    def __init__(self, fullname: str, path: str, fault: Plant) -> None:
        super().__init__(fullname, path)
        self.fault = fault

    def get_code(self, fullname: str) -> CodeType:
        """From the source, not from the byte code beside it, which is that of the sound one; nor is any written."""
        source = self.fault.planted(self.get_data(self.path).decode("utf-8"))
        code: CodeType = compile(source, self.path, "exec", dont_inherit=True)
        return code
