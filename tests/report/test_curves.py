"""Curves to draw: on one grid, without round-off."""

from dataclasses import replace

import numpy as np

from vmharness.report.figures.curves import curves


def test_curves_of_one_unit_share_a_figure(good):
    assert [[curve.channel for curve in figure] for figure in curves(good)] == [
        ["z"],
        ["v"],
        ["kinetic", "contact", "external"],
    ]
    assert [figure[0].unit for figure in curves(good)] == ["in", "in/s", "lbf-in"]


def test_a_history_that_is_theory_has_a_residual_of_exactly_zero_where_it_is_smooth(good):
    z = curves(good)[0][0]
    assert not np.any(z.residual)
    assert not np.any(np.signbit(z.residual))


def test_a_real_difference_is_kept(good):
    history = good.solution.history
    shifted = {**history.channels, "z": history["z"] + 2e-5}
    run = replace(good, solution=replace(good.solution, history=replace(history, channels=shifted)))
    z = curves(run)[0][0]
    assert np.abs(z.residual - 2e-5).max() < 2e-8


def test_tolerances_stand_at_their_events(good):
    z = curves(good)[0][0]
    assert set(z.allowed) == {"z_impact", "z_peak"}
    time, allowed = z.allowed["z_peak"]
    assert time == good.case.theory["t_peak"]
    assert allowed == good.rows[-1].comparison.tolerance.allowed(good.case.theory["z_peak"])
