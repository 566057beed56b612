"""The folder is the list: find the modules of a drop-in package, and hold each to the folder's contract.

What other installed packages offer under an entry point group is found in the same way.
"""

from collections.abc import Iterator
from hashlib import sha256
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint


class ContractError(ImportError):
    """A module of a drop-in folder lacks something that its folder requires of all."""


def names(package: str) -> list[str]:
    """Names of the modules in the folder of `package`, in alphabetical order; none of them is imported.

    A name that begins with an underscore is private to the folder, and no drop-in.

    >>> "shell" in names("vmharness.explicit.elements"), "_law" in names("vmharness.explicit.materials")
    (True, False)
    """
    found = (module.name for module in iter_modules(import_module(package).__path__))
    return sorted(name for name in found if not name.startswith("_"))


def rooms(package: str) -> list[str]:
    """Names of the sub-packages in the folder of `package`: where each drop-in is a folder of its own.

    >>> rooms("vmharness.backends")
    ['builtin', 'calculix', 'mujoco', 'opensees']
    """
    path = import_module(package).__path__
    return sorted(
        found.name for found in iter_modules(path) if found.ispkg and not found.name.startswith("_")
    )


def module(package: str, name: str, *required: str) -> ModuleType:
    """Import the module `name` of the folder of `package`; raises ContractError if it lacks a `required` name."""
    found = import_module(f"{package}.{name}")
    require(found, package, *required)
    return found


def require(found: ModuleType, package: str, *required: str) -> None:
    """Raise ContractError, which names the file, if a module of the folder of `package` lacks a `required` name."""
    if missing := [each for each in required if not hasattr(found, each)]:
        file = getattr(found, "__file__", repr(found))
        raise ContractError(f"{file}: a module of {package} must define {', '.join(missing)}")


def modules(package: str, *required: str) -> list[ModuleType]:
    """Import every module in the folder of `package`; one that fails to import is fatal.

    Each must define the `required` names, else ContractError names the file. A sub-package that defines none of them
    is a family: the modules of its folder count in its place.
    """
    return list(_modules(package, required))


def _modules(package: str, required: tuple[str, ...]) -> Iterator[ModuleType]:
    for name in names(package):
        found = module(package, name)
        if required and hasattr(found, "__path__") and not any(hasattr(found, each) for each in required):
            yield from _modules(found.__name__, required)
        else:
            yield module(package, name, *required)


def offered(group: str) -> "dict[str, list[EntryPoint]]":
    """The entry points of `group` in all installed packages, by name; none of them is imported."""
    from importlib.metadata import (
        entry_points,  # reads every installed package's, and takes a while to import
    )

    found: dict[str, list[EntryPoint]] = {}
    for point in entry_points(group=group):
        found.setdefault(point.name, []).append(point)
    return found


def load(point: "EntryPoint", *required: str) -> ModuleType:
    """Import the module of an entry point; raises ContractError if it lacks a `required` name."""
    found: ModuleType = point.load()
    require(found, point.group, *required)
    return found


def describe(point: "EntryPoint") -> str:
    """The module of an entry point and its package, for messages."""
    return f"{point.value} of the package {point.dist.name}" if point.dist else point.value


def digest(module: ModuleType) -> str:
    """SHA-256 of the file of a module, or of all sources of a package."""
    file = Path(str(module.__file__))
    files = sorted(file.parent.rglob("*.py")) if hasattr(module, "__path__") else [file]
    return sha256(b"\0".join(file.read_bytes() for file in files)).hexdigest()
