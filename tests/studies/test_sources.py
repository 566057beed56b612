"""Which sources count for a measured value: what they say, not how they are written or where they lie."""

import ast
import shutil
from pathlib import Path

import pytest

from vmharness.studies import sources as module
from vmharness.studies.sources import modules, sources

PACKAGE = module.PACKAGE


@pytest.fixture
def edited(tmp_path, monkeypatch):
    """The hash of a copy of the package in another folder, in which texts of modules are replaced."""
    copy = Path(
        shutil.copytree(PACKAGE, tmp_path / "vmharness", ignore=shutil.ignore_patterns("__pycache__"))
    )
    monkeypatch.setattr(module, "PACKAGE", copy)
    caches = (module.sources, module._read)

    def hashed(name: str = "", old: str = "", new: str = "") -> str:
        if name:
            text = (copy / name).read_text()
            assert old in text
            (copy / name).write_text(text.replace(old, new))
        for cached in caches:
            cached.cache_clear()
        return sources()

    yield hashed
    for cached in caches:
        cached.cache_clear()


def test_the_folder_of_the_package_does_not_count(edited):
    assert edited() == HASH


HASH = sources()


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("explicit/loop.py", "Yield the state", "Give the state"),
        ("explicit/materials/elastic.py", "\n\n\n", "\n\n\n# A comment.\n\n"),
        ("events.py", "    return ", "    return  "),
        ("explicit/materials/elastic.py", "da=only(0.0)", "da=only(1.0)"),
        ("explicit/model/rigid_bodies.py", '"drflag": only(0)', '"drflag": only(1)'),
        ("explicit/contact/supported.py", '"fs", "fd"', '"fd"'),
        ("explicit/model/curve.py", "extend it", "continue it"),
        ("report/wording.py", '"', "'"),
        ("cli/say.py", "import", "import math, "),
        ("studies/sweep/runs.py", "1", "2"),
    ],
    ids=lambda text: None if text.endswith(".py") else "",
)
def test_what_does_not_count(edited, name, old, new):
    assert edited(name, old, new) == HASH


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("explicit/loop.py", "0.5 * ", "0.25 * "),
        ("explicit/materials/elastic.py", "plate = e /", "plate = e *"),
        ("explicit/contact/friction.py", "return scale(-k", "return scale(k"),
        ("explicit/materials/elastic.py", "entry.error(", "entry.mistake("),
        ("events.py", "float(time[i])", "float(time[i - 1])"),
        ("studies/measured.py", "c.share", "c.value"),
        ("studies/thinning.py", "return ", "return None or "),
    ],
    ids=lambda text: None if text.endswith(".py") else "",
)
def test_what_counts(edited, name, old, new):
    if old not in (PACKAGE / name).read_text():
        pytest.fail(f"{name} has no {old!r}: bring the test up to date")
    assert edited(name, old, new) != HASH


def test_no_module_of_the_solver_is_left_out():
    found = set(modules())
    for room in ("explicit", "deck", "backends/builtin"):
        for path in (PACKAGE / room).rglob("*.py"):
            parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
            assert ".".join(part for part in parts if part != "__init__") in found


def test_pages_commands_and_studies_are_not_sources_of_a_value():
    rooms = {name.split(".")[1] for name in modules() if "." in name}
    assert not rooms & {"report", "cli", "suite"}
    running = {name for name in modules() if name.startswith("vmharness.execution.")}
    assert running == {"vmharness.execution.memory"}  # the bound of what a template may fill
    studies = {name for name in modules() if name.startswith("vmharness.studies.")}
    assert studies == {"vmharness.studies.measured", "vmharness.studies.thinning"}


def test_what_is_imported_for_a_type_checker_alone_does_not_count():
    text = "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import a\nelse:\n    import b\n"
    assert set(module._named(ast.parse(text))) == {"typing", "typing.TYPE_CHECKING", "b"}


def test_imports_in_functions_and_handlers_count():
    text = "def f():\n    try:\n        import a\n    except E:\n        from b import c\n"
    assert set(module._named(ast.parse(text))) == {"a", "b", "b.c"}
