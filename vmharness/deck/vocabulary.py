"""The keywords that a reader knows: the folder is the list."""

from collections.abc import Iterator
from importlib import import_module
from pkgutil import walk_packages
from types import ModuleType

from vmharness.deck.keyword import Keyword

KEYWORDS = "vmharness.deck.keywords"


def vocabulary(package: str = KEYWORDS) -> dict[str, Keyword]:
    """All `Keyword` objects, alone or in tuples, of the modules in the folder of `package`, by name and alias.

    Raises ValueError where two modules define the same name.
    """
    found: dict[str, Keyword] = {}
    for module in _modules(package):
        for value in vars(module).values():
            for keyword in value if isinstance(value, tuple) else (value,):
                if isinstance(keyword, Keyword):
                    _add(found, keyword, module.__name__)
    return found


def _modules(package: str) -> Iterator[ModuleType]:
    """The modules of a folder and of the folders in it; one that fails to import is fatal."""
    for module in walk_packages(import_module(package).__path__, f"{package}."):
        yield import_module(module.name)


def _add(found: dict[str, Keyword], keyword: Keyword, module: str) -> None:
    for name in (keyword.name, *keyword.aliases):
        if found.setdefault(name, keyword) is not keyword:
            raise ValueError(f"{module}: *{name} is defined already, by {found[name]!r}")
