"""The cache of compiled kernels: a changed source never runs as it was before."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from vmharness.explicit.kernels import cache

PACKAGE = Path(__file__).parents[3] / "vmharness"

# One square shell, stretched by 0.1 % in one step: its stress at the first point.
STRETCH = """
import numpy as np
from vmharness.explicit.elements.shell.belytschko_tsay import BelytschkoTsay
from vmharness.explicit.materials import elastic
from vmharness.explicit.model.state import State
x = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
v = np.zeros((4, 3))
v[1:3, 0] = 1e-3
n = np.zeros((4, 3))
shell = BelytschkoTsay("s", np.array([[0, 1, 2, 3]]), x, np.ones(1), 1.0, elastic.plane_stress,
                       (1000.0, 0.0), (1000.0, 0.0))
shell.add(State(x + v, v, n, np.ones(4), np.ones(4), dt=1.0))
print(shell.stress[0, 0, 0])
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


def test_an_edited_material_law_is_seen_by_the_element(package, monkeypatch):
    monkeypatch.setenv("VMHARNESS_CACHE", str(package / "cache"))
    before = run(package)
    assert before == pytest.approx(1.0, rel=1e-3)
    law = package / "vmharness" / "explicit" / "materials" / "elastic.py"
    text = law.read_text()
    assert "plate = e / (1 - nu * nu)" in text
    law.write_text(text.replace("plate = e / (1 - nu * nu)", "plate = 2 * e / (1 - nu * nu)"))
    assert run(package) == pytest.approx(2.0 * before, rel=1e-12)
    law.write_text(text)
    assert run(package) == before


def test_compiled_and_plain_python_agree(package):
    compiled = run(package, VMHARNESS_CACHE=str(package / "cache"))
    plain = run(package, NUMBA_DISABLE_JIT="1", VMHARNESS_CACHE=str(package / "none"))
    assert plain == pytest.approx(compiled, rel=1e-14)


def test_a_second_process_compiles_nothing(package):
    root = package / "cache"
    run(package, VMHARNESS_CACHE=str(root))
    compiled = {path: path.stat().st_mtime_ns for path in root.rglob("*.nb[ci]")}
    assert compiled
    run(package, VMHARNESS_CACHE=str(root))
    assert {path: path.stat().st_mtime_ns for path in root.rglob("*.nb[ci]")} == compiled


def test_old_folders_are_removed_and_the_newest_stay(tmp_path, monkeypatch):
    monkeypatch.setenv("VMHARNESS_CACHE", str(tmp_path))
    monkeypatch.setenv("NUMBA_CACHE_DIR", "")  # put back afterwards
    for age in range(8):
        old = tmp_path / f"kernels-{age}"
        old.mkdir()
        os.utime(old, (1e9 - age, 1e9 - age))
    (tmp_path / "other").mkdir()
    assert cache.prepare()
    kept = {path.name for path in tmp_path.iterdir()}
    assert kept == {cache.folder().name, "other", *(f"kernels-{age}" for age in range(cache.KEEP))}


def test_cold_until_something_is_compiled(tmp_path, monkeypatch):
    monkeypatch.setenv("VMHARNESS_CACHE", str(tmp_path))
    assert cache.is_cold()
    (cache.folder() / "x").mkdir(parents=True)
    (cache.folder() / "x" / "kernel.nbi").touch()
    assert not cache.is_cold()


def test_without_a_writable_folder_kernels_still_compile(package):
    blocked = package / "file"
    blocked.write_text("not a folder")
    assert run(package, VMHARNESS_CACHE=str(blocked)) == pytest.approx(1.0, rel=1e-3)
