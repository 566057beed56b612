"""Settings for all tests."""

import os
import shutil
import sys

import pytest
from hypothesis import settings

from vmharness.backends import identity
from vmharness.case.new import new

# The first call of a kernel may compile it, so no time limits; the same examples on every machine.
settings.register_profile("vmharness", deadline=None, derandomize=True)
settings.load_profile("vmharness")


@pytest.fixture
def installed(tmp_path, monkeypatch):
    """Installs a package that offers a solver, for this process and for those that it starts."""

    def install(name, source, package=None):
        package = package or f"{name}_adapter"
        site = tmp_path / f"site {package}"
        info = site / f"{package}-1.0.dist-info"
        info.mkdir(parents=True, exist_ok=True)
        (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n")
        (info / "entry_points.txt").write_text(f"[vmharness.solvers]\n{name} = {package}\n")
        (site / f"{package}.py").write_text(source)
        monkeypatch.syspath_prepend(site)
        monkeypatch.setenv("PYTHONPATH", str(site), prepend=os.pathsep)
        monkeypatch.delitem(sys.modules, package, raising=False)
        identity.cache_clear()
        return site

    yield install
    identity.cache_clear()


@pytest.fixture
def fall(tmp_path):
    """Makes the folder of a mass in free fall, the case of `vm new`, with texts replaced in its files."""

    def write(*replacements, id="fall"):
        folder = tmp_path / id
        shutil.rmtree(folder, ignore_errors=True)
        new(folder)
        case, deck = folder / "case.toml", folder / "deck.k"
        text = case.read_text().replace('because = ""', 'because = "the budget"')
        case.write_text(text.replace('title     = ""', 'title = "Fall"').replace('= ""', '= "A book"'))
        for old, other in replacements:
            file = next(file for file in (case, deck) if old in file.read_text())
            file.write_text(file.read_text().replace(old, other, 1))
        return folder

    return write
