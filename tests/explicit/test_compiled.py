"""Kernels that do not count their arrays must not hand any out: the caller would free what is still in use."""

import inspect

import pytest

from vmharness import dropins
from vmharness.explicit import elements, materials, penalty, plasticity

ARRAYS = ("Array", "Index", "Indices", "Records", "Record", "Curve", "Table", "Any")


def uncounted_functions():
    """By name, all kernels compiled without counts, of the modules that loops over elements and contacts use."""
    found = {}
    for package in (penalty, plasticity, materials, elements):
        for module in dropins.modules(package.__name__):
            for name, value in vars(module).items():
                if getattr(value, "targetoptions", {}).get("_nrt") is False:
                    found[f"{value.py_func.__module__}.{name}"] = value.py_func
    return found


def test_there_are_such_functions():
    assert len(uncounted_functions()) > 20


@pytest.mark.parametrize("name", sorted(uncounted_functions()))
def test_none_returns_an_array(name):
    returned = str(inspect.signature(uncounted_functions()[name]).return_annotation)
    assert not any(kind in returned.replace("Vector", "") for kind in ARRAYS), returned
