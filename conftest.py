"""Doctests of modules that import the package of another solver are collected where that package is installed."""

from importlib.util import find_spec

IMPORTING = {
    "mujoco": ["vmharness/backends/mujoco/child.py", "vmharness/backends/mujoco/readers.py"],
    "openseespy": ["vmharness/backends/opensees/child.py"],
}

collect_ignore = [
    file for package, files in IMPORTING.items() if find_spec(package) is None for file in files
]
