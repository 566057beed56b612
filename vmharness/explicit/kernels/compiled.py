"""Kernels: plain functions on arrays, compiled by numba; with NUMBA_DISABLE_JIT=1 they run as plain Python."""

import types
from collections.abc import Callable
from typing import Any, TypeVar

import numba

from vmharness.explicit.kernels.kept import Kept

# NaN stays NaN and operations keep their order ("contract" only fuses a*b + c); division by zero gives inf.
OPTIONS: dict[str, Any] = {"error_model": "numpy", "fastmath": {"contract"}, "no_cfunc_wrapper": True}
# For kernels that neither make nor return arrays: those that they are given are not counted as they are handed on,
# which takes 10 ns each time.
UNCOUNTED: dict[str, Any] = {**OPTIONS, "_nrt": False}

Function = TypeVar("Function", bound=Callable[..., Any])


class UnboundError(TypeError):
    """A kernel uses a name that `specialise` has to bind and has not bound."""


class Unbound:
    """A function, or a number, that `specialise` has to bind; a call of it raises UnboundError."""

    def __init__(self, name: str) -> None:
        self.name = name

    def __call__(self, *arguments: Any) -> Any:
        """Raise UnboundError."""
        raise UnboundError(
            f"{self.name} is not bound: compile its caller by specialise(..., {self.name}=...)"
        )


def to_be_bound(name: str) -> Any:
    """Mark the global `name` of a module as a function, or a number, that `specialise` binds."""
    return Unbound(name)


def compiled(function: Function, **options: Any) -> Function:
    """Compile `function`; its compiled form is kept on disk for the next process.

    Raises UnboundError if it uses a name that is not bound.
    """
    for name in function.__code__.co_names:
        if isinstance(function.__globals__.get(name), Unbound):
            raise UnboundError(f"{function.__module__}.{function.__qualname__}: {name} is not bound")
    kernel: Function = numba.njit(**options)(function)
    if kernel is not function:  # with NUMBA_DISABLE_JIT=1
        setattr(kernel, "_cache", Kept(kernel))  # noqa: B010
    return kernel


def kernel(function: Function) -> Function:
    """A kernel of the general kind."""
    return compiled(function, **OPTIONS)


def concurrent(function: Function) -> Function:
    """A kernel beside which other threads run: for loops over all nodes or elements, since it costs 50 ns a call."""
    return compiled(function, **OPTIONS, nogil=True)


def uncounted(function: Function) -> Function:
    """A kernel that neither makes nor returns arrays, in place where it is called many times for little."""
    return compiled(function, **UNCOUNTED)


def inlined(function: Callable[..., Any]) -> Any:
    """An uncounted kernel that is inlined where it is called."""
    return compiled(function, **UNCOUNTED, forceinline=True)


def inlined_counted(function: Callable[..., Any]) -> Any:
    """As `inlined`, for functions that return arrays: the caller counts what it is given as its own."""
    return compiled(function, **OPTIONS, forceinline=True)


def interpreted(kernel: Callable[..., Any]) -> Callable[..., Any]:
    """The function that a kernel is compiled from; it also takes arrays where the kernel takes numbers."""
    function: Callable[..., Any] = getattr(kernel, "py_func", kernel)
    return function


def specialise(function: Callable[..., Any], **bound: Any) -> Callable[..., Any]:
    """Compile a copy of plain `function` in which the global names of `bound` stand for other kernels, or numbers.

    An element kernel is written once and compiled for just the material laws that a deck uses. Raises TypeError for a
    name that the function does not use, UnboundError for one that it needs and is not given.
    """
    for name in bound:
        if name not in function.__code__.co_names:
            raise TypeError(
                f"{function.__module__}.{function.__qualname__} has no global name {name} to bind"
            )
    scope = {**function.__globals__, **bound}
    copy = types.FunctionType(function.__code__, scope, function.__name__, function.__defaults__)
    copy.__module__ = function.__module__
    return concurrent(copy)
