"""Settings for all tests."""

import os
import sys

import pytest
from hypothesis import settings

from vmharness.backends import identity

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
