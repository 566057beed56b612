"""Calls of a solver: what the module of another package raises is an error of that solver, not of vmharness."""

import functools
from collections.abc import Callable
from subprocess import SubprocessError
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

from vmharness import backends, plugins
from vmharness.backends import BackendError, backend

if TYPE_CHECKING:
    from vmharness.backends.protocol import Backend
    from vmharness.deck.support import Supported

FUNCTIONS = ("found", "review", "reports", "solve")


def solver(name: str) -> "Backend":
    """The solver `name`; its functions raise BackendError, which names it, in place of an unexpected exception.

    An exception of a solver of this package stays as it is: it is a defect of vmharness.
    """
    module = backend(name)
    functions = {each: _named(name, each, getattr(module, each)) for each in FUNCTIONS}
    return cast("Backend", SimpleNamespace(NAME=module.NAME, **functions))


def supported(name: str) -> "Supported | None":
    """What the solver `name` declares to support of each keyword; None if it declares nothing."""
    if not hasattr(backend(name), "supported"):
        return None
    return cast("Supported", _named(name, "supported", backends.supported)(name))


def get_ready(name: str) -> None:
    """Let the solver `name` import what it needs, if it has the optional function `get_ready`."""
    _named(name, "get_ready", getattr(backend(name), "get_ready", lambda: None))()


def identity(name: str) -> tuple[str, ...]:
    """As `vmharness.backends.identity`; raises BackendError where the solver cannot be asked for its version."""
    return _named(name, "found", backends.identity)(name)


def _named(name: str, what: str, function: Callable[..., Any]) -> Callable[..., Any]:
    """The function of a solver; an unexpected exception becomes a BackendError that says whose it is."""
    if name in plugins.rooms(backends.__name__):
        return function

    @functools.wraps(function)
    def call(*arguments: Any) -> Any:
        try:
            return function(*arguments)
        except Exception as error:
            if isinstance(error, _allowed()):
                raise
            raise BackendError(f"solver {name}: {what} failed: {type(error).__name__}: {error}") from error

    return call


def _allowed() -> tuple[type[Exception], ...]:
    """The exceptions that the protocol allows; the import waits, for a fault may have to be planted before it."""
    from vmharness.deck import DeckError

    return (BackendError, DeckError, SubprocessError)
