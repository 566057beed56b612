"""The keywords that a reader knows: the folder is the list."""

from vmharness import plugins
from vmharness.deck.keyword import Keyword


def vocabulary(*packages: str) -> dict[str, Keyword]:
    """All `Keyword` objects, alone or in tuples, of the modules in `packages`, by name and alias.

    Raises ValueError where two modules define the same name.
    """
    found: dict[str, Keyword] = {}
    for package in packages:
        for module in plugins.modules(package):
            for value in vars(module).values():
                for keyword in value if isinstance(value, tuple) else (value,):
                    if isinstance(keyword, Keyword):
                        _add(found, keyword, module.__name__)
    return found


def _add(found: dict[str, Keyword], keyword: Keyword, module: str) -> None:
    for name in (keyword.name, *keyword.aliases):
        if found.setdefault(name, keyword) is not keyword:
            raise ValueError(f"{module}: *{name} is defined already, by {found[name]!r}")
