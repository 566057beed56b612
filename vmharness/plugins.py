"""The folder is the list: find the modules of a drop-in package, and hold each to the folder's contract."""

from collections.abc import Iterator
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType


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


def module(package: str, name: str, *required: str) -> ModuleType:
    """Import the module `name` of the folder of `package`; raises ContractError if it lacks a `required` name."""
    found = import_module(f"{package}.{name}")
    require(found, package, *required)
    return found


def require(found: ModuleType, package: str, *required: str) -> None:
    """Raise ContractError, which names the file, if a module of the folder of `package` lacks a `required` name."""
    if missing := [each for each in required if not hasattr(found, each)]:
        raise ContractError(f"{found.__file__}: a module of {package} must define {', '.join(missing)}")


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
