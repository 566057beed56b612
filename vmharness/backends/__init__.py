"""Solvers: the packages in this folder, and the modules that other installed packages offer as entry points:

    [project.entry-points."vmharness.solvers"]
    mycode = "mypackage.adapter"

A solver has the name of its folder or of its entry point, which must be unique. protocol.py says what it must define.
"""

from functools import cache
from types import ModuleType
from typing import TYPE_CHECKING, cast

from vmharness import plugins

if TYPE_CHECKING:
    from vmharness.backends.protocol import Backend
    from vmharness.deck.support import Supported

GROUP = "vmharness.solvers"
REQUIRED = ("NAME", "found", "review", "reports", "solve")


class BackendError(Exception):
    """A solver does not exist, or cannot be used, and why."""


def names() -> list[str]:
    """Names of all solvers; none of them is imported."""
    return sorted({*plugins.rooms(__name__), *plugins.offered(GROUP)})


@cache
def identity(name: str) -> tuple[str, ...]:
    """Name, version and machine of a solver, and a hash of its adapter: outcomes of other solvers have another one.

    The hash is empty for a solver of this package, whose sources studies/sources.py counts. Raises BackendError.
    """
    solver = backend(name)
    found = solver.found()
    sources = "" if name in plugins.rooms(__name__) else plugins.digest(cast(ModuleType, solver))
    return (name, found.version, found.machine, sources)


def backend(name: str) -> "Backend":
    """The solver `name`.

    Raises BackendError if there is none of that name, if two packages offer it, and if its module cannot be imported or
    lacks a name of `REQUIRED`.
    """
    room, offers = name in plugins.rooms(__name__), plugins.offered(GROUP).get(name, [])
    places = [f"{__name__}.{name}"] * room + [plugins.describe(offer) for offer in offers]
    if not places:
        raise BackendError(f"no solver {name}; there are: {', '.join(names())}")
    if len(places) > 1:
        raise BackendError(f"solver {name} is offered twice, by {' and by '.join(places)}; uninstall one")
    try:
        found = plugins.module(__name__, name, *REQUIRED) if room else plugins.load(offers[0], *REQUIRED)
    except Exception as error:  # any error of the import concerns this solver only
        raise BackendError(f"solver {name}, {places[0]}: {type(error).__name__}: {error}") from error
    return cast("Backend", found)


def supported(name: str) -> "Supported":
    """What the solver `name` declares to support of each keyword, if it does; raises BackendError."""
    declared = getattr(backend(name), "supported", dict)
    return cast("Supported", declared())
