"""D-70: the balance behind its results."""

from pathlib import Path

import numpy as np

from vmharness.backends import builtin
from vmharness.case import read
from vmharness.solve import solve

CASE = read(Path(__file__).parents[1] / "cases" / "D-70")


def test_momentum_of_the_bouncing_bar_is_what_the_walls_gave():
    h = solve(CASE, builtin).history
    np.testing.assert_allclose(h["p"], h["p"][0] + h["J_1"] + h["J_2"], atol=1e-12 * h["p"][0])
    assert np.ptp(h["J_1"]) > 9.0 * h["p"][0]
