"""What a kernel computes: what counts for its hash, and what does not."""

import importlib
import inspect
import pkgutil
import types

import numpy as np
import pytest

import vmharness.explicit
from vmharness.explicit.kernels import meaning
from vmharness.explicit.kernels.compiled import concurrent, inlined, kernel, specialise, uncounted
from vmharness.explicit.kernels.vector import add, subtract

# A kernel, what it calls, and what that calls.
SOURCE = """
import numpy as np
from vmharness.explicit.kernels import vector
from vmharness.explicit.kernels.compiled import kernel

FACTOR = 2.0
PLACES = (1, 2.0, ("x", None))
WEIGHTS = np.array([1.0, 2.0])

@kernel
def inner(a: float) -> float:
    \"\"\"Twice a.\"\"\"
    return FACTOR * a  # a comment

@kernel
def middle(a: float, b: float = 1.0) -> float:
    return inner(a) + b + PLACES[0] + WEIGHTS[1]

@kernel
def outer(a: float) -> float:
    return middle(a) + vector.dot((a, a, a), (a, a, a)) + np.sin(a)
"""


def key(changes: dict[str, str], name: str = "vmharness.here") -> str:
    """The hash of `outer` in the source with these texts in place of others."""
    source = SOURCE
    for old, new in changes.items():
        assert old in source
        source = source.replace(old, new)
    module = types.ModuleType(name)
    exec(compile(source, f"/{name}.py", "exec"), vars(module))
    return meaning.digest(module.outer)


def test_the_hash_is_the_same_each_time():
    assert key({}) == key({})


@pytest.mark.parametrize(
    "changes",
    [
        {"  # a comment": ""},
        {"Twice a.": "Two times a."},
        {"FACTOR = 2.0": "\n\n\n\nFACTOR = 2.0"},
        {"inner(a: float) -> float": "inner(a)"},
        {"PLACES = (1,": "OTHER = 3.0\nPLACES = (1,"},
    ],
    ids=["comment", "docstring", "lines", "annotations", "unused constant"],
)
def test_what_does_not_count(changes):
    assert key(changes) == key({})


def test_names_of_modules_and_paths_do_not_count():
    assert key({}, "elsewhere.there") == key({})


@pytest.mark.parametrize(
    "changes",
    [
        {"FACTOR * a": "FACTOR / a"},
        {"FACTOR = 2.0": "FACTOR = 2"},
        {"FACTOR = 2.0": "FACTOR = -2.0"},
        {"(1, 2.0": "(1.0, 2.0"},
        {'("x", None)': '("y", None)'},
        {"[1.0, 2.0]": "[1.0, 3.0]"},
        {"b: float = 1.0": "b: float = 1.5"},
        {"np.sin": "np.cos"},
        {"vector.dot((a, a, a)": "vector.cross((a, a, a)"},
        {"import kernel\n": "import concurrent as kernel\n"},
        {
            "@kernel\ndef inner": "from vmharness.explicit.kernels.compiled import inlined\n@inlined\ndef inner"
        },
    ],
    ids=lambda changes: "; ".join(f"{old} -> {new}".replace("\n", " ") for old, new in changes.items()),
)
def test_what_counts_at_any_depth(changes):
    assert key(changes) != key({})


def law(a: float) -> float:
    """A law that is bound to another."""
    return a


def update(a: float) -> float:
    """A loop that calls the law."""
    return law(a)


def test_what_is_bound_counts():
    one = kernel(lambda a: a + 1.0)
    two = kernel(lambda a: a + 2.0)
    assert meaning.digest(specialise(update, law=one)) != meaning.digest(specialise(update, law=two))
    same = kernel(lambda a: a + 1.0)
    assert meaning.digest(specialise(update, law=one)) == meaning.digest(specialise(update, law=same))


def test_options_count():
    def twice(a: float) -> float:
        return 2.0 * a

    compiled = [options(twice) for options in (kernel, concurrent, uncounted, inlined)]
    assert len({meaning.digest(one) for one in compiled}) == len(compiled)


def even(n: int) -> bool:
    return True if n == 0 else odd(n - 1)


def odd(n: int) -> bool:
    return False if n == 0 else even(n - 1)


def test_a_circle_of_calls_ends():
    assert meaning.digest(even) != meaning.digest(odd)
    assert meaning.digest(even) == meaning.digest(even)


def test_values_of_a_closure_count():
    def shifted(by: float):
        return lambda a: a + by

    assert meaning.digest(shifted(1.0)) == meaning.digest(shifted(1.0))
    assert meaning.digest(shifted(1.0)) != meaning.digest(shifted(2.0))


def test_a_value_of_an_unknown_kind_is_said():
    def strange(a: float) -> float:
        return a + unknown  # type: ignore[name-defined]  # noqa: F821

    scope = {**globals(), "unknown": object()}
    with pytest.raises(meaning.MeaningError, match=r"<object object at .*> in a kernel"):
        meaning.digest(types.FunctionType(strange.__code__, scope))


def test_a_constant_that_is_replaced_while_the_kernel_runs_is_not_kept(tmp_path, monkeypatch):
    module = types.ModuleType("vmharness.here")
    exec(SOURCE, vars(module))
    monkeypatch.setattr("vmharness.explicit.kernels.kept.FOLDER", tmp_path)
    module.inner(1.0)
    (kept,) = tmp_path.iterdir()
    module.FACTOR = 3.0
    assert module.inner(1) == 3.0  # compiled anew, for an integer
    assert list(tmp_path.iterdir()) == [kept]


def kernels() -> dict[str, object]:
    """Every compiled function of the solver, by module and name."""
    found = {}
    for module in pkgutil.walk_packages(vmharness.explicit.__path__, "vmharness.explicit."):
        for name, value in vars(importlib.import_module(module.name)).items():
            if hasattr(value, "py_func"):
                found[f"{module.name}.{name}"] = value
    return found


def test_every_kernel_of_the_solver_has_a_hash():
    found = kernels()
    assert len(found) > 200
    assert all(meaning.digest(one) for one in found.values())


def test_kernels_of_the_solver_that_differ_have_different_hashes():
    assert meaning.digest(add) != meaning.digest(subtract)
    assert inspect.isfunction(add.py_func)
    assert np.isfinite(add((1.0, 0.0, 0.0), (1.0, 0.0, 0.0))).all()
