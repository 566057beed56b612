"""What a kernel computes, as a hash: of its byte code and of all that it refers to, wherever that stands.

The numbers, options and other kernels behind its global names count, to any depth. Paths, line numbers, comments,
docstrings, annotations and the names of modules do not.
"""

import hashlib
from collections.abc import Iterator
from functools import cache
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

NATIVE = ("numpy", "numba", "math", "builtins")  # packages whose functions the compiler knows by name


class MeaningError(TypeError):
    """A kernel refers to an object whose effect on the compiled code is unknown."""


def digest(kernel: Any) -> str:
    """The hash of a kernel, compiled or plain.

    Functions are numbered in the order in which they are met, so that those that call each other in a circle end it.
    """
    hashed = hashlib.sha256()
    met = {id(kernel): 0}
    queue = [kernel]
    for function in queue:  # grows on the way
        text, references = _content(function)
        hashed.update(text)
        for reference in references:
            if id(reference) not in met:
                met[id(reference)] = len(queue)
                queue.append(reference)
            hashed.update(b"%d," % met[id(reference)])
    return hashed.hexdigest()[:24]


def forget() -> None:
    """Read every function anew, for the next hash."""
    _content.cache_clear()


@cache
def _content(kernel: Any) -> tuple[bytes, list[Any]]:
    """What stands in a function itself, and the functions that it refers to, in their order."""
    references: list[Any] = []
    facts = [*_options(kernel), *_function(getattr(kernel, "py_func", kernel), references)]
    return "\0".join(facts).encode(), references


def _options(kernel: Any) -> Iterator[str]:
    for name, value in sorted(getattr(kernel, "targetoptions", {}).items()):
        yield f"{name}={sorted(value) if isinstance(value, set | frozenset) else value!r}"


def _function(function: FunctionType, references: list[Any]) -> Iterator[str]:
    yield from _code(function.__code__, function.__doc__)
    cells = [cell.cell_contents for cell in function.__closure__ or ()]
    for value in (function.__defaults__, function.__kwdefaults__, tuple(cells)):
        yield from _value(value, (), references)
    names = set(_names(function.__code__))
    for name in sorted(names & function.__globals__.keys()):
        yield name
        yield from _value(function.__globals__[name], names, references)


def _code(code: CodeType, doc: str | None) -> Iterator[str]:
    """Byte code with its names and constants; a docstring is the first constant."""
    yield from (code.co_code.hex(), repr(code.co_names), repr(code.co_varnames), repr(code.co_flags))
    yield from (repr(code.co_freevars), repr(code.co_cellvars), code.co_exceptiontable.hex())
    yield repr((code.co_argcount, code.co_kwonlyargcount, code.co_posonlyargcount))
    for number, constant in enumerate(code.co_consts):
        if isinstance(constant, CodeType):
            yield from _code(constant, None)
        else:
            yield _constant(None if number == 0 and constant == doc else constant)


def _constant(constant: Any) -> str:
    """A set of constants has no order of its own."""
    return f"{{{sorted(map(repr, constant))}}}" if isinstance(constant, frozenset) else repr(constant)


def _names(code: CodeType) -> Iterator[str]:
    """Names of globals and attributes, also of functions within the function."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _value(value: Any, names: Any, references: list[Any]) -> Iterator[str]:
    """What the value of a global name is to the compiler; of a module, the attributes among `names`."""
    if hasattr(value, "py_func") or (isinstance(value, FunctionType) and not _is_native(value)):
        references.append(value)
        yield "function"
    elif value is None or isinstance(
        value, bool | int | float | complex | str | bytes | np.generic | np.dtype
    ):
        yield repr(value)
    elif isinstance(value, tuple):
        yield f"{type(value).__name__}{getattr(value, '_fields', '')}{len(value)}"
        for item in value:
            yield from _value(item, names, references)
    elif isinstance(value, np.ndarray):
        yield f"{value.dtype!r}{value.shape}{value.flags.c_contiguous}{value.tobytes().hex()}"
    elif isinstance(value, ModuleType):
        yield from _module(value, names, references)
    elif isinstance(value, type) and issubclass(value, tuple) and hasattr(value, "_fields"):
        yield f"{value.__name__}{value._fields}"
        yield from _value(tuple(getattr(value, "_field_defaults", {}).items()), names, references)
    elif _is_native(value) or (isinstance(value, type) and issubclass(value, BaseException)):
        yield f"{getattr(value, '__module__', '')}.{getattr(value, '__qualname__', value)}"
    else:
        raise MeaningError(f"{value!r} in a kernel: of no kind that meaning.py knows")


def _module(module: ModuleType, names: Any, references: list[Any]) -> Iterator[str]:
    """A package of the compiler by its name, another by what is used of it."""
    if module.__name__.partition(".")[0] in NATIVE:
        yield module.__name__
        return
    for name in sorted(names & vars(module).keys()):
        yield name
        yield from _value(vars(module)[name], names, references)


def _is_native(value: Any) -> bool:
    """Whether it belongs to a package whose functions the compiler knows by name."""
    if not callable(value):
        return False
    owner = getattr(value, "__module__", None) or type(value).__module__
    return str(owner).partition(".")[0] in NATIVE
