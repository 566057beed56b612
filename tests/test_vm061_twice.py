"""The theory of VM-061 derived a second time, from its equation of motion by scipy's integrator with events."""

from pathlib import Path

import pytest
from scipy.integrate import solve_ivp

from vmharness.case import read


def test_targets_follow_from_the_equation_of_motion():
    # m z'' = -m g + k <-(z + h)>, z(0) = z'(0) = 0
    case = read(Path(__file__).parents[1] / "cases" / "VM-061")
    m, k, h, g = (case.given[name] for name in "mkhg")

    def motion(t, y):
        return [y[1], -g + k / m * max(-(y[0] + h), 0.0)]

    def touches(t, y):
        return y[0] + h

    def turns(t, y):
        return y[1]

    touches.terminal, touches.direction = True, -1
    turns.terminal, turns.direction = True, 1
    exact = {"rtol": 1e-12, "atol": 1e-14, "method": "DOP853"}
    fall = solve_ivp(motion, (0.0, 1.0), [0.0, 0.0], events=touches, **exact)
    (t_impact,), ((z, v),) = fall.t_events[0], fall.y_events[0]
    dive = solve_ivp(motion, (t_impact, 1.0), [-h, v], events=turns, **exact)
    (t_peak,), ((z_peak, _),) = dive.t_events[0], dive.y_events[0]

    derived = dict(
        t_impact=t_impact, z_impact=z, v_impact=v, ke_impact=m * v**2 / 2, t_peak=t_peak, z_peak=z_peak
    )
    for result in case.file.results:
        assert derived.pop(result.key) == pytest.approx(case.target(result.key), rel=1e-9)
    assert not derived
