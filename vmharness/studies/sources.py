"""Which sources a measured value depends on, and a hash of what they say: comments and docstrings do not count.

Nor does what only refuses a deck, or says why: a value exists where nothing was refused. So the declarations of what is
supported (`SUPPORTS`, with what serves them alone), the modules that review them, and the texts of errors are left out.
They are the modules that run a case and read its results, and all that these import, found in the sources: the same on
every machine, and without importing anything.
"""

import ast
import copy
import hashlib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import vmharness

PACKAGE = Path(vmharness.__file__).parent
MEASURING = ("vmharness.run", "vmharness.studies.measured")
REFUSING = {  # modules that can refuse a deck, and change no value
    "vmharness.deck.finding", "vmharness.deck.rule", "vmharness.deck.support",
    "vmharness.explicit.references", "vmharness.explicit.references.cards",
    "vmharness.explicit.references.defined", "vmharness.explicit.references.parts",
    "vmharness.explicit.supported", "vmharness.explicit.without_effect",
    "vmharness.explicit.contact.control_contact", "vmharness.explicit.contact.supported",
    "vmharness.explicit.contact.without_effect",
}  # fmt: skip
DECLARES = "SUPPORTS"
FINDERS = {"vmharness.plugins", "pkgutil", "importlib"}  # a module that imports one imports others as it runs


@cache
def sources(solver: str = "builtin") -> str:
    """The hash of all that a value measured in a run of the `solver` depends on."""
    found = hashlib.sha256()
    for name in sorted(set(modules(solver)) - REFUSING):
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
    text = file.read_bytes() if file else b""
    tree = ast.parse(text)
    names = frozenset(_named(tree))
    if DECLARES.encode() in text:
        tree = _without_declarations(tree)
    return hashlib.sha256(_said(tree).encode()).hexdigest(), names


def _without_declarations(tree: ast.Module) -> ast.Module:
    """A module without what it declares as supported, and without what it defines or imports for that alone."""
    kept = [statement for statement in tree.body if _defined(statement) != {DECLARES}]
    declared = {name for statement in tree.body if statement not in kept for name in _used(statement)}
    while declared:
        uses = {id(statement): _used(statement) for statement in kept}
        served = [
            statement
            for statement in kept
            if (own := _defined(statement)) and own <= declared
            and not any(own & uses[id(other)] for other in kept if other is not statement)
        ]  # fmt: skip
        if not served:
            break
        kept = [statement for statement in kept if statement not in served]
        declared |= {name for statement in served for name in _used(statement)}
    used = {name for statement in kept for name in _used(statement)}
    left = [_importing(statement, declared - used) for statement in kept]
    return ast.Module([statement for statement in left if statement is not None], [])


def _defined(statement: ast.stmt) -> set[str]:
    """The names that a statement of a module assigns or defines."""
    if isinstance(statement, ast.FunctionDef | ast.ClassDef):
        return {statement.name}
    targets = getattr(statement, "targets", [getattr(statement, "target", None)])
    return {
        node.id for target in targets if target for node in ast.walk(target) if isinstance(node, ast.Name)
    }


def _used(statement: ast.stmt) -> set[str]:
    """The names that a statement reads, and the texts that may be names in `__all__`."""
    own = _defined(statement)
    names = {node.id for node in ast.walk(statement) if isinstance(node, ast.Name)} - own
    if own == {"__all__"}:
        names |= {str(node.value) for node in ast.walk(statement) if isinstance(node, ast.Constant)}
    return names


def _importing(statement: ast.stmt, alone: set[str]) -> ast.stmt | None:
    """An import without the names that serve declarations `alone`; any other statement as it is."""
    if not isinstance(statement, ast.ImportFrom):
        return statement
    names = [alias for alias in statement.names if (alias.asname or alias.name) not in alone]
    return ast.ImportFrom(statement.module, names, statement.level) if names else None


def _said(value: object) -> str:
    """A syntax tree as text, the same in every version of Python: without what is empty, and without docstrings.

    >>> _said(ast.parse("def f(x):\\n    'Twice x.'\\n    return 2 * x  # plain"))
    ... # doctest: +ELLIPSIS
    "Module([FunctionDef('f',arguments([arg('x')]),[Return(BinOp(Constant(2),Mult(),Name('x',Load())))])])"
    """
    if isinstance(value, ast.Raise | ast.Call) and _is_error(value):
        value = _Wordless().visit(copy.deepcopy(value))
    if isinstance(value, ast.AST):
        fields = (part for _, part in ast.iter_fields(value) if part is not None and part != [])
        return f"{type(value).__name__}({','.join(map(_said, fields))})"
    if isinstance(value, list):
        return f"[{','.join(_said(part) for part in value if not _is_text(part))}]"
    return repr(value)


class _Wordless(ast.NodeTransformer):
    """Takes the words out of an error."""

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        return ast.Constant("") if isinstance(node.value, str) else node


def _is_error(node: ast.Raise | ast.Call) -> bool:
    """Whether a node makes an error: a `raise`, or a call as `entry.error("pr", "must lie between -1 and 0.5")`."""
    return isinstance(node, ast.Raise) or (isinstance(node.func, ast.Attribute) and node.func.attr == "error")


def _is_text(node: object) -> bool:
    """Whether a statement is a text alone, as a docstring is."""
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )
