"""Kernels that do not count their arrays must not hand any out: the caller would free what is still in use."""

import inspect
from importlib import import_module
from pkgutil import walk_packages

import pytest

from vmharness import explicit

ARRAYS = ("Array", "Index", "Indices", "Records", "Record", "Curve", "Table", "Any")


def uncounted_functions():
    """By name, all kernels of the solver that are compiled without counts."""
    found = {}
    for module in walk_packages(explicit.__path__, f"{explicit.__name__}."):
        for name, value in vars(import_module(module.name)).items():
            if getattr(value, "targetoptions", {}).get("_nrt") is False:
                found[f"{value.__module__}.{name}"] = value.py_func
    return found


def test_there_are_such_functions():
    assert len(uncounted_functions()) > 150


@pytest.mark.parametrize("name", sorted(uncounted_functions()))
def test_none_returns_an_array(name):
    returned = str(inspect.signature(uncounted_functions()[name]).return_annotation)
    assert not any(kind in returned.replace("Vector", "") for kind in ARRAYS), returned
