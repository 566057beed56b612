"""Solvers: the rooms of this folder, and what other installed packages offer by the entry point group `GROUP`.

    [project.entry-points."vmharness.solvers"]
    mycode = "mypackage.adapter"

The name is that of the room or of the entry point; protocol.py says what the module must define. A name is taken once.
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
    """A solver that there is not, or that cannot be used, and why."""


def names() -> list[str]:
    """The solvers that there are; none of them is imported."""
    return sorted({*plugins.rooms(__name__), *plugins.offered(GROUP)})


@cache
def identity(name: str) -> tuple[str, ...]:
    """What tells an outcome of this solver from others: name, version, machine, and sources of an installed adapter.

    Those of a room of this package are sources of the package. Raises BackendError.
    """
    solver = backend(name)
    found = solver.found()
    sources = "" if name in plugins.rooms(__name__) else plugins.digest(cast(ModuleType, solver))
    return (name, found.version, found.machine, sources)


def backend(name: str) -> "Backend":
    """The solver `name`.

    Raises BackendError where there is none of that name, where two places offer it, and where its module cannot be
    imported or does not keep the contract.
    """
    room, offers = name in plugins.rooms(__name__), plugins.offered(GROUP).get(name, [])
    places = [f"{__name__}.{name}"] * room + [plugins.said(offer) for offer in offers]
    if not places:
        raise BackendError(f"no solver {name}; there are: {', '.join(names())}")
    if len(places) > 1:
        raise BackendError(f"solver {name} is offered twice, by {' and by '.join(places)}; uninstall one")
    try:
        found = plugins.module(__name__, name, *REQUIRED) if room else plugins.load(offers[0], *REQUIRED)
    except Exception as error:  # whatever its import raises is the matter of this solver alone
        raise BackendError(f"solver {name}, {places[0]}: {type(error).__name__}: {error}") from error
    return cast("Backend", found)


def supported(name: str) -> "Supported":
    """What the solver `name` declares to support of each keyword, if it does; raises BackendError."""
    declared = getattr(backend(name), "supported", dict)
    return cast("Supported", declared())
