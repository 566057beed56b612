"""Names that are bound later: the message says which one is missing, and where."""

import os
import subprocess
import sys

import pytest

from vmharness.explicit.elements.shell import _point as shell_point
from vmharness.explicit.kernels.compiled import UnboundError, kernel, specialise, to_be_bound
from vmharness.explicit.materials.elastic import plane_stress

law = to_be_bound("law")


def twice(x):
    return 2 * law(x)


def square(x):
    return x * x


def test_a_bound_function_is_called():
    assert specialise(twice, law=kernel(square))(3.0) == 18.0


def test_a_missing_one_is_named_before_it_is_compiled():
    with pytest.raises(UnboundError, match=r"_point\.stress_at_point: law is not bound"):
        specialise(shell_point.stress_at_point)
    with pytest.raises(UnboundError, match=r"twice: law is not bound"):
        kernel(twice)


def test_a_missing_one_is_named_in_plain_python():
    with pytest.raises(
        UnboundError, match=r"law is not bound: compile its caller by specialise\(\.\.\., law="
    ):
        twice(3.0)


def test_the_same_is_said_without_the_compiler():
    script = (
        "from vmharness.explicit.elements.solid import _stress\n"
        "from vmharness.explicit.kernels.compiled import specialise\n"
        "specialise(_stress.stress_at_point)\n"
    )
    env = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run([sys.executable, "-c", script], env=env, capture_output=True, text=True)
    assert (
        "UnboundError: vmharness.explicit.elements.solid._stress.stress_at_point: law is not bound"
        in done.stderr
    )


def test_a_name_that_a_function_does_not_use_is_refused():
    with pytest.raises(TypeError, match="twice has no global name lay to bind"):
        specialise(twice, lay=plane_stress)
