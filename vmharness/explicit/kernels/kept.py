"""The cache of one kernel, in the place of numba's own, which goes by the path and the text of one file."""

import hashlib
import pickle
from pathlib import Path
from typing import Any

from numba.core import types
from numba.core.caching import _Cache
from numba.core.compiler import CompileResult
from numba.core.serialize import dumps

from vmharness.explicit.kernels import cache, meaning

FOLDER = cache.folder()
PACKAGE = __name__.partition(".")[0]


class Kept(_Cache):
    """Loads and saves what numba compiles of one kernel.

    What a kernel refers to is complete only when it is first called, so its hash is made then. Compiled code carries
    the names of function and module: they are replaced by names that hold the hash, so that equal names are equal code,
    and a module that has moved is not looked for where it was.
    """

    def __init__(self, kernel: Any) -> None:
        self.kernel = kernel
        self.digest = ""

    @property
    def cache_path(self) -> str:
        """For numba's statistics."""
        return str(FOLDER)

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The compiled form for these argument types; None where there is none, or it does not fit."""
        self._rename()
        target_context.refresh()
        path = self._path(sig, target_context.codegen())
        if path is None or (content := cache.load(path)) is None:
            return None
        try:
            return CompileResult._rebuild(target_context, *pickle.loads(content))
        except Exception:  # whatever unpickling raises: a class of numba's may have moved
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Write the compiled form, unless what the kernel refers to has been replaced since its first call."""
        path = self._path(sig, data.codegen)
        if path is None or data.library.has_dynamic_globals or data.lifted:
            return
        meaning.forget()
        if meaning.digest(self.kernel) == self.digest:
            cache.save(path, dumps(data._reduce()))

    def enable(self) -> None:
        """Always on."""

    def disable(self) -> None:
        """Always on."""

    def flush(self) -> None:
        """No file is stale: a changed kernel has another name."""

    def _rename(self) -> None:
        if self.digest:
            return
        try:
            self.digest = meaning.digest(self.kernel)
        except meaning.MeaningError:
            return
        function = self.kernel.py_func
        function.__module__ = PACKAGE
        function.__qualname__ = f"{function.__name__}_{self.digest}"

    def _path(self, sig: Any, codegen: Any) -> Path | None:
        """The file for these argument types and this processor; None where the compiled form cannot be kept."""
        arguments = sig if isinstance(sig, tuple) else sig.args
        if not self.digest or "Dispatcher(" in str(sig):  # a kernel as an argument: its name holds an address
            return None
        facts = repr((str(arguments), [_classes(argument) for argument in arguments], codegen.magic_tuple()))
        return (
            FOLDER / f"{self.kernel.__name__}-{self.digest}-{hashlib.sha256(facts.encode()).hexdigest()[:16]}"
        )


def _classes(argument: Any) -> list[Any]:
    """The named tuples within an argument's type, whose own names do not tell their fields."""
    if not isinstance(argument, types.BaseTuple):
        return []
    named = getattr(argument, "instance_class", tuple)
    own = [named.__module__, named.__qualname__, getattr(named, "_fields", ())]
    return [*own, *map(_classes, getattr(argument, "types", ()))]
