"""Which sources a measured value depends on, and a hash of what they say: comments and docstrings do not count.

They are the modules that run a case and read its results, and all that these import, found in the sources: the same on
every machine, and without importing anything.
"""

import ast
import hashlib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import vmharness

PACKAGE = Path(vmharness.__file__).parent
MEASURING = ("vmharness.run", "vmharness.studies.measured")
FINDERS = {"vmharness.plugins", "pkgutil", "importlib"}  # a module that imports one imports others as it runs


@cache
def sources(solver: str = "builtin") -> str:
    """The hash of all that a value measured in a run of the `solver` depends on."""
    found = hashlib.sha256()
    for name in modules(solver):
        found.update(f"{name}\0{_read(name)[0]}\0".encode())
    return found.hexdigest()


def modules(solver: str = "builtin") -> list[str]:
    """Names of the modules that these sources are.

    >>> {"vmharness.events", "vmharness.explicit.elements.beam.truss", "vmharness.case.read"} <= set(modules())
    True
    >>> any(name.startswith(("vmharness.report", "vmharness.cli")) for name in modules())
    False
    """
    found: set[str] = set()
    waiting = [*MEASURING, f"vmharness.backends.{solver}"]
    while waiting:
        name = waiting.pop()
        if name not in found and _file(name) is not None:
            found.add(name)
            waiting += [*_imported(name), *_parents(name)]
    return sorted(found)


def _parents(name: str) -> list[str]:
    """The packages that a module lies in: they are imported before it."""
    parts = name.split(".")
    return [".".join(parts[:count]) for count in range(1, len(parts))]


def _imported(name: str) -> Iterator[str]:
    """What may be modules among the names that a module imports, or that lie in its room if it finds them as it runs.

    The solvers are such a room, of which only one runs.
    """
    named = _read(name)[1]
    yield from named
    room = ".".join(name.split(".")[:2])
    if room not in ("vmharness.backends", "vmharness.plugins") and not FINDERS.isdisjoint(named):
        for path in PACKAGE.parent.joinpath(*room.split(".")).rglob("*.py"):
            parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
            yield ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def _named(node: ast.AST) -> Iterator[str]:
    """Absolute names after `import`, and the name before it; what is imported for a type checker is not."""
    for child in ast.iter_child_nodes(node):
        if (
            isinstance(child, ast.If)
            and isinstance(child.test, ast.Name)
            and child.test.id == "TYPE_CHECKING"
        ):
            yield from _named(ast.Module(child.orelse, []))
        elif isinstance(child, ast.Import):
            yield from (alias.name for alias in child.names)
        elif isinstance(child, ast.ImportFrom) and child.module:
            yield child.module
            yield from (f"{child.module}.{alias.name}" for alias in child.names)
        elif isinstance(child, ast.stmt | ast.excepthandler | ast.match_case):
            yield from _named(child)


def _file(name: str) -> Path | None:
    """The file of a module of this package; None for any other name."""
    head, *rest = name.split(".")
    path = PACKAGE.joinpath(*rest)
    files = (path / "__init__.py", path.with_name(f"{path.name}.py"))
    return next((file for file in files if head == PACKAGE.name and file.is_file()), None)


@cache
def _read(name: str) -> tuple[str, frozenset[str]]:
    """A hash of what a module says, and the names that it imports."""
    file = _file(name)
    tree = ast.parse(file.read_bytes() if file else b"")
    return hashlib.sha256(_said(tree).encode()).hexdigest(), frozenset(_named(tree))


def _said(value: object) -> str:
    """A syntax tree as text, the same in every version of Python: without what is empty, and without docstrings.

    >>> _said(ast.parse("def f(x):\\n    'Twice x.'\\n    return 2 * x  # plain"))
    ... # doctest: +ELLIPSIS
    "Module([FunctionDef('f',arguments([arg('x')]),[Return(BinOp(Constant(2),Mult(),Name('x',Load())))])])"
    """
    if isinstance(value, ast.AST):
        fields = (part for _, part in ast.iter_fields(value) if part is not None and part != [])
        return f"{type(value).__name__}({','.join(map(_said, fields))})"
    if isinstance(value, list):
        return f"[{','.join(_said(part) for part in value if not _is_text(part))}]"
    return repr(value)


def _is_text(node: object) -> bool:
    """Whether a statement is a text alone, as a docstring is."""
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )
