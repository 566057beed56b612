"""The cache of compiled kernels: a changed source never runs as it was before."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from vmharness.backends import builtin
from vmharness.explicit.kernels import cache

PACKAGE = Path(__file__).parents[3] / "vmharness"

# One square shell, stretched by 0.1 % in one step: its stress at the first point.
STRETCH = """
import numpy as np
from vmharness.explicit.elements.shell.belytschko_tsay import BelytschkoTsay
from vmharness.explicit.materials import Moduli, elastic
from vmharness.explicit.state import State
x = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
v = np.zeros((4, 3))
v[1:3, 0] = 1e-3
n = np.zeros((4, 3))
shell = BelytschkoTsay("s", np.array([[0, 1, 2, 3]]), x, np.ones(1), 1.0, elastic.plane_stress,
                       elastic.Elastic(1000.0, 0.0), Moduli(1000.0, 0.0))
shell.add(State(x + v, v, n, np.ones(4), np.ones(4), dt=1.0))
print(shell.stress[0, 0, 0])
"""

# How many kernels of the process were compiled.
COUNT = """
import gc
from numba.core.dispatcher import Dispatcher
kernels = [one for one in gc.get_objects() if isinstance(one, Dispatcher) and one.__module__.startswith("vmharness")]
print(sum(sum(one.stats.cache_hits.values()) for one in kernels), "hits")
print(sum(sum(one.stats.cache_misses.values()) for one in kernels), "misses")
assert any(one.stats.cache_hits for one in kernels)
"""


def run(folder: Path, **environment: str) -> float:
    """The stress, from a process of its own that imports vmharness from `folder`."""
    env = {**os.environ, "PYTHONPATH": str(folder), **environment}
    done = subprocess.run(
        [sys.executable, "-c", STRETCH], env=env, cwd=folder, capture_output=True, text=True, check=True
    )
    return float(done.stdout)


@pytest.fixture
def package(tmp_path):
    """A copy of the sources."""
    shutil.copytree(PACKAGE, tmp_path / "vmharness", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


def test_an_edited_material_law_is_seen_by_the_element(package, root, monkeypatch):
    monkeypatch.setenv("VMHARNESS_CACHE", str(root))
    before = run(package)
    assert before == pytest.approx(1.0, rel=1e-3)
    law = package / "vmharness" / "explicit" / "materials" / "elastic.py"
    text = law.read_text()
    assert "plate = e / (1 - nu * nu)" in text
    law.write_text(text.replace("plate = e / (1 - nu * nu)", "plate = 2 * e / (1 - nu * nu)"))
    assert run(package) == pytest.approx(2.0 * before, rel=1e-12)
    law.write_text(text)
    assert run(package) == before


def test_compiled_and_plain_python_agree(package, root):
    compiled = run(package, VMHARNESS_CACHE=str(root))
    plain = run(package, NUMBA_DISABLE_JIT="1", VMHARNESS_CACHE=str(package / "none"))
    assert plain == pytest.approx(compiled, rel=1e-14)
    assert not (package / "none").exists()


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """A cache that holds the kernels of one run."""
    root = tmp_path_factory.mktemp("compiled")
    run(PACKAGE.parent, VMHARNESS_CACHE=str(root))
    return root


@pytest.fixture
def root(package, compiled):
    """A copy of that cache, beside the copy of the sources."""
    return Path(shutil.copytree(compiled, package / "cache"))


def files(root: Path) -> dict[str, int]:
    """The kernels of a cache, and when each was written."""
    return {path.name: path.stat().st_mtime_ns for path in root.glob("kernels-*/*")}


def test_a_second_process_compiles_nothing(package, root):
    compiled = files(root)
    assert compiled
    assert "0 misses" in run_and_count(package, root)
    assert files(root) == compiled


def run_and_count(folder: Path, root: Path) -> str:
    """What numba's statistics say of all kernels of a process."""
    env = {**os.environ, "PYTHONPATH": str(folder), "VMHARNESS_CACHE": str(root)}
    done = subprocess.run(
        [sys.executable, "-c", STRETCH + COUNT],
        env=env,
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout


def test_another_copy_of_the_package_with_other_comments_compiles_nothing(package, root, tmp_path):
    compiled = files(root)
    other = tmp_path / "other"
    shutil.copytree(package / "vmharness", other / "vmharness", ignore=shutil.ignore_patterns("__pycache__"))
    for law in (other / "vmharness" / "explicit").rglob("*.py"):
        text = law.read_text()
        law.write_text("# One more line.\n\n" + text if "from __future__" not in text else text)
    assert "0 misses" in run_and_count(other, root)
    assert files(root) == compiled


def test_a_module_of_another_name_compiles_nothing(package, root):
    compiled = files(root)
    sources = package / "vmharness" / "explicit"
    (sources / "kernels" / "vector.py").rename(sources / "kernels" / "space.py")
    for source in sources.rglob("*.py"):
        source.write_text(source.read_text().replace("kernels.vector", "kernels.space"))
    assert "0 misses" in run_and_count(package, root)
    assert files(root) == compiled


def test_an_edited_law_compiles_only_the_kernels_that_use_it(package, root):
    before = set(files(root))
    law = package / "vmharness" / "explicit" / "materials" / "elastic.py"
    law.write_text(law.read_text().replace("plate = e / (1 - nu * nu)", "plate = 3 * e / (1 - nu * nu)"))
    run(package, VMHARNESS_CACHE=str(root))
    added = {name.partition("-")[0] for name in set(files(root)) - before}
    assert "plane_stress" in added
    assert not added & {"add", "cross", "dot", "length", "frame"}
    assert len(added) < len(before) / 3


def test_damaged_files_are_compiled_anew(package, root):
    sound = run(package, VMHARNESS_CACHE=str(root))
    for number, path in enumerate(sorted(root.glob("kernels-*/*"))):
        content = path.read_bytes()
        half = len(content) // 2
        flipped = content[:half] + bytes([content[half] ^ 1]) + content[half + 1 :]
        path.write_bytes([b"", b"\0" * 100, content[:half], flipped][number % 4])
    assert run(package, VMHARNESS_CACHE=str(root)) == sound
    assert "0 misses" in run_and_count(package, root)


def test_old_folders_are_removed_and_the_newest_stay(tmp_path):
    for age in range(8):
        old = tmp_path / f"kernels-{age}"
        old.mkdir()
        os.utime(old, (1e9 - age, 1e9 - age))
    (tmp_path / "other").mkdir()
    (tmp_path / "kernels-now").mkdir()
    cache.clean(tmp_path / "kernels-now")
    kept = {path.name for path in tmp_path.iterdir()}
    assert kept == {"kernels-now", "other", *(f"kernels-{age}" for age in range(cache.FOLDERS))}


def test_old_kernels_are_removed_where_there_are_too_many(tmp_path, monkeypatch):
    monkeypatch.setattr(cache, "FILES", 8)
    folder = tmp_path / "kernels-now"
    folder.mkdir()
    for age in range(9):
        (folder / f"{age}").touch()
        os.utime(folder / f"{age}", (1e9 - age, 1e9 - age))
    cache.save(folder / "new", b"code")
    assert {path.name for path in folder.iterdir()} == {"new", *"012345"}
    assert cache.load(folder / "new") == b"code"


def test_cold_until_something_is_compiled(tmp_path, monkeypatch):
    monkeypatch.setenv("VMHARNESS_CACHE", str(tmp_path))
    assert cache.is_cold()
    cache.save(cache.folder() / "kernel", b"code")
    assert not cache.is_cold()


def test_without_a_writable_folder_kernels_still_compile(package):
    blocked = package / "file"
    blocked.write_text("not a folder")
    assert run(package, VMHARNESS_CACHE=str(blocked)) == pytest.approx(1.0, rel=1e-3)


def test_a_folder_that_cannot_be_written_is_said_before_a_run(tmp_path, monkeypatch):
    monkeypatch.setenv("VMHARNESS_CACHE", str(tmp_path))
    assert "cannot be kept" not in builtin.found().notice
    (tmp_path / "occupied").write_text("")
    monkeypatch.setenv("VMHARNESS_CACHE", str(tmp_path / "occupied"))
    assert "compiled kernels cannot be kept" in builtin.found().notice
    assert "Not a directory" in builtin.found().notice


def test_without_a_home_no_folder_can_be_written(monkeypatch):
    for name in ("VMHARNESS_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", raising(RuntimeError))
    assert "compiled kernels cannot be kept" in builtin.found().notice


def raising(error):
    def home():
        raise error

    return home
