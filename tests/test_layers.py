"""Imports point one way: every module may import from its own layer's right only."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "vmharness"

# A module of a layer imports from layers before it, and from its own. What stands in one layer together is independent.
LAYERS = [
    {"plugins", "round_off", "cache"},
    {"formula", "history", "events", "compare", "deck", "execution"},
    {"mesh"},
    {"explicit", "case"},
    {"result"},
    {"measure"},
    {"reading"},
    {"backends"},
    {"solve"},
    {"run"},
    {"studies"},
    {"report"},
    {"suite"},
    {"cli"},
    {"__main__"},
]
LEVEL = {name: level for level, layer in enumerate(LAYERS) for name in layer}
APART = {
    "formula",
    "history",
    "events",
    "compare",
    "deck",
    "mesh",
    "explicit",
    "case",
    "execution",
}  # these know nothing of their neighbours


def layer_of(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imported(path: Path) -> set[str]:
    """First names below vmharness that a module imports, wherever in it."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] == "vmharness":
            names = node.module.split(".")[1:2] or [alias.name for alias in node.names]
            found.update(names)
        elif isinstance(node, ast.Import):
            found.update(a.name.split(".")[1] for a in node.names if a.name.startswith("vmharness."))
    return found - {"__version__"}


MODULES = sorted(path for path in PACKAGE.rglob("*.py") if path != PACKAGE / "__init__.py")


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_imports_point_one_way(path):
    own = layer_of(path)
    assert own in LEVEL, f"{own} has no layer: add it where it belongs"
    for name in imported(path) - {own}:
        assert LEVEL[name] < LEVEL[own] or (LEVEL[name] == LEVEL[own] and not {name, own} <= APART), (
            f"{own} imports {name}"
        )


def test_the_solver_knows_nothing_of_the_harness():
    for path in (PACKAGE / "explicit").rglob("*.py"):
        assert imported(path) <= {"deck", "mesh", "cache", "plugins", "explicit"}, path


SOLVER = ("vmharness.explicit", "vmharness.backends.builtin")


def test_no_module_knows_the_built_in_solver_but_itself():
    own = (PACKAGE / "explicit", PACKAGE / "backends" / "builtin")
    for path in MODULES:
        if not any(path.is_relative_to(room) for room in own):
            assert not [name for name in full_names(path) if name.startswith(SOLVER)], path


def full_names(path: Path) -> list[str]:
    """The modules that a module imports, and the names that it takes from them."""
    found = []
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            found += [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.Import):
            found += [alias.name for alias in node.names]
    return found


def test_the_check_can_fail(tmp_path):
    wrong = tmp_path / "wrong.py"
    wrong.write_text("def f():\n    from vmharness.report import page\n    import vmharness.cli.say\n")
    assert imported(wrong) == {"report", "cli"}
    wrong.write_text("def f():\n    from vmharness.backends import backend, builtin\n")
    assert full_names(wrong) == ["vmharness.backends.backend", "vmharness.backends.builtin"]


def name_of(path: Path) -> str:
    """The dotted name of a module."""
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported_at_once(source: str, modules: set[str]) -> set[str]:
    """Those of `modules` that a source imports when it is itself imported: not in functions, not for type checkers."""
    found, todo = set[str](), list[ast.stmt](ast.parse(source).body)
    while todo:
        node = todo.pop()
        if isinstance(node, ast.ImportFrom) and node.module:
            full = {alias.name: f"{node.module}.{alias.name}" for alias in node.names}
            found.update(name if name in modules else node.module for name in full.values())
        elif isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            todo += node.orelse
        elif isinstance(node, ast.If | ast.Try | ast.With):
            todo += [*node.body, *getattr(node, "orelse", [])]
    return found & modules


def test_no_module_imports_itself_by_way_of_others():
    paths = {name_of(path): path for path in PACKAGE.rglob("*.py")}
    graph = {name: imported_at_once(path.read_text(), set(paths)) for name, path in paths.items()}
    TopologicalSorter(graph).prepare()  # raises CycleError, which names the modules of the circle


def test_imports_for_type_checkers_and_in_functions_make_no_circle():
    source = """
import a
from b import c
from b import d
if TYPE_CHECKING:
    import e
def f():
    import g
"""
    assert imported_at_once(source, {"a", "b", "b.c", "e", "g"}) == {"a", "b", "b.c"}
