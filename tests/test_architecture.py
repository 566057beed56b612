"""Imports follow the arrows of docs/architecture.md, and none leads back."""

import ast
import re
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "vmharness"
DIAGRAMS = re.findall(r"```mermaid\n(.*?)```", (ROOT / "docs" / "architecture.md").read_text(), re.DOTALL)
MODULES = sorted(path for path in PACKAGE.rglob("*.py") if path != PACKAGE / "__init__.py")

Arrows = dict[str, set[str]]


def arrows(diagram: str) -> Arrows:
    """Where the arrows of each room lead, in a diagram."""
    found: Arrows = {}
    for room, other in re.findall(r"(\w+) --> (\w+)", diagram):
        found.setdefault(room, set()).add(other)
    return found


def reached(graph: Arrows, room: str) -> set[str]:
    """The rooms to which arrows lead from a room, directly or through others."""
    found: set[str] = set()
    waiting = [room]
    while waiting:
        for other in graph.get(waiting.pop(), set()) - found:
            found.add(other)
            waiting.append(other)
    return found


def imports(tree: ast.AST) -> Iterator[str]:
    """Full names that a module imports, wherever in it, but for type checkers."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue
        if isinstance(node, ast.ImportFrom) and node.module:
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        yield from imports(node)


def imported(path: Path, package: str = "vmharness") -> set[str]:
    """The rooms of `package` that a module imports."""
    names = imports(ast.parse(path.read_text()))
    found = {
        name.removeprefix(f"{package}.").split(".")[0] for name in names if name.startswith(f"{package}.")
    }
    return found - {"__version__"}


def rooms(folder: Path) -> Arrows:
    """The rooms of a folder, and which of them the modules of each import."""
    package = ".".join(folder.relative_to(ROOT).parts)
    found: Arrows = {}
    for path in folder.rglob("*.py"):
        room = path.relative_to(folder).parts[0].removesuffix(".py")
        if room != "__init__":
            found.setdefault(room, set()).update(imported(path, package) - {room})
    return found


@pytest.mark.parametrize(("folder", "diagram"), [(PACKAGE, DIAGRAMS[0]), (PACKAGE / "explicit", DIAGRAMS[1])])
def test_imports_follow_the_arrows(folder, diagram):
    drawn, real = arrows(diagram), rooms(folder)
    TopologicalSorter(drawn).prepare()  # raises CycleError where an arrow leads back
    for room, others in real.items():
        assert others & real.keys() <= reached(drawn, room), (
            f"{room}: an import that no arrow of the diagram allows"
        )
    for room, others in drawn.items():
        assert others <= real[room], f"{room}: an arrow for which there is no import"


def test_an_import_against_the_arrows_is_found(tmp_path):
    wrong = tmp_path / "wrong.py"
    wrong.write_text("def f():\n    from vmharness.report import page\n    import vmharness.cli.say\n")
    assert imported(wrong) == {"report", "cli"}
    drawn = arrows("a --> b\n b --> c\n")
    assert reached(drawn, "a") == {"b", "c"}
    assert reached(drawn, "c") == set()


def test_the_solver_knows_nothing_of_the_harness():
    for path in (PACKAGE / "explicit").rglob("*.py"):
        assert imported(path) <= {"deck", "mesh", "cache", "plugins", "explicit"}, path


SOLVER = ("vmharness.explicit", "vmharness.backends.builtin")


def test_no_module_knows_the_built_in_solver_but_itself():
    own = (PACKAGE / "explicit", PACKAGE / "backends" / "builtin")
    for path in MODULES:
        if not any(path.is_relative_to(room) for room in own):
            assert not [name for name in imports(ast.parse(path.read_text())) if name.startswith(SOLVER)], (
                path
            )


def test_a_module_that_knows_the_solver_is_found():
    source = "def f():\n    from vmharness.backends import backend, builtin\n"
    assert list(imports(ast.parse(source))) == ["vmharness.backends.backend", "vmharness.backends.builtin"]


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
