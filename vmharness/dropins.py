"""The folder is the list: find the modules of a drop-in package."""

from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType


def names(package: str) -> list[str]:
    """Names of the modules in the folder of `package`, in alphabetical order; none of them is imported.

    >>> "mass" in names("vmharness.explicit.elements")
    True
    """
    return sorted(module.name for module in iter_modules(import_module(package).__path__))


def module(package: str, name: str) -> ModuleType:
    """Import the module `name` of the folder of `package`."""
    return import_module(f"{package}.{name}")


def modules(package: str) -> list[ModuleType]:
    """Import every module in the folder of `package`; one that fails to import is fatal."""
    return [module(package, name) for name in names(package)]
