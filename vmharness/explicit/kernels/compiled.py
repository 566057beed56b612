"""Kernels: plain functions on arrays, compiled by numba; with NUMBA_DISABLE_JIT=1 they run as plain Python."""

import os
import types
from collections.abc import Callable
from typing import Any, TypeVar

from vmharness.explicit.kernels import cache

CACHED = cache.prepare()  # before numba is imported: it reads its folder then

import numba  # noqa: E402

if CACHED:
    # In case someone imported numba before us.
    setattr(numba.config, "CACHE_DIR", os.environ["NUMBA_CACHE_DIR"])  # noqa: B010

# NaN stays NaN and operations keep their order ("contract" only fuses a*b + c); division by zero gives inf.
OPTIONS: dict[str, Any] = {"cache": CACHED, "error_model": "numpy", "fastmath": {"contract"}}
# For kernels that neither make nor return arrays: those that they are given are not counted as they are handed on,
# which takes 10 ns each time.
UNCOUNTED: dict[str, Any] = {**OPTIONS, "_nrt": False}

Function = TypeVar("Function", bound=Callable[..., Any])


def kernel(function: Function, nogil: bool = False) -> Function:
    """Compile `function`; its compiled form is kept on disk for the next process."""
    compiled: Function = numba.njit(**OPTIONS, nogil=nogil)(function)
    return compiled


def concurrent(function: Function) -> Function:
    """A kernel beside which other threads run: for loops over all nodes or elements, since it costs 50 ns a call."""
    return kernel(function, nogil=True)


def uncounted(function: Function) -> Function:
    """A kernel that neither makes nor returns arrays, in place where it is called many times for little."""
    compiled: Function = numba.njit(**UNCOUNTED)(function)
    return compiled


def specialise(function: Callable[..., Any], **bound: Callable[..., Any]) -> Callable[..., Any]:
    """Compile a copy of plain `function` in which the global names of `bound` stand for other kernels.

    An element kernel is written once and compiled for just the material laws that a deck uses. The copy carries the
    names of what it is bound to, so that each combination has an entry of its own in the cache.
    """
    parts = [getattr(part, "py_func", part) for part in bound.values()]
    suffix = "".join(f"__{part.__module__.rpartition('.')[2]}_{part.__name__}" for part in parts)
    scope = {**function.__globals__, **bound}
    copy = types.FunctionType(function.__code__, scope, function.__name__ + suffix, function.__defaults__)
    copy.__qualname__ = function.__qualname__ + suffix
    copy.__module__ = function.__module__
    return concurrent(copy)
