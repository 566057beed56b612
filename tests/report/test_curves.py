"""Curves to draw: on one grid, without round-off."""

from dataclasses import replace

import numpy as np
import pytest
from msgspec import structs

from vmharness.case.format import as_line
from vmharness.report.figures import histories
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


@pytest.fixture
def in_millimetres(good, result_row):
    """The run with the results for the displacement in mm; `line` are further keys of its curve."""

    def other(**line):
        case, curve = good.case, as_line(good.case.file.curves["z"])
        results = [
            structs.replace(result, unit="mm") if result.channel == "z" else result
            for result in case.file.results
        ]
        drawn = {**case.file.curves, "z": structs.replace(curve, **line)}
        case = replace(case, file=structs.replace(case.file, results=results, curves=drawn))
        return replace(good, case=case, rows=tuple(result_row(case, each.key, 0.5) for each in results))

    return other


def test_a_bar_is_the_tolerance_in_the_unit_of_the_curve(good, in_millimetres):
    run = in_millimetres(unit="in")
    peak = next(row for row in run.rows if row.key == "z_peak").comparison
    z = curves(run)[0][0]
    assert z.unit == "in"
    assert z.allowed["z_peak"][1] == pytest.approx(peak.tolerance.allowed(peak.target) / 25.4, rel=1e-12)
    assert z.allowed["z_peak"][1] == pytest.approx(1e-5 * 1.5506656122, rel=1e-9)
    # The half-height of the bars that are drawn is that of the same problem with its results in inches.
    assert histories.draw(run, "h", [z], "solver") == histories.draw(good, "h", curves(good)[0], "solver")


def test_a_curve_is_drawn_in_the_unit_of_its_results(good, in_millimetres):
    z, inches = curves(in_millimetres())[0][0], curves(good)[0][0]
    assert z.unit == "mm"
    np.testing.assert_allclose(z.computed, 25.4 * inches.computed, rtol=1e-4, atol=1e-4)
    assert z.allowed["z_peak"][1] == pytest.approx(25.4 * inches.allowed["z_peak"][1], rel=1e-12)


def test_time_is_drawn_in_the_unit_of_results_that_are_times(good, result_row):
    results = [
        structs.replace(result, unit="ms") if result.channel == "time" else result
        for result in good.case.file.results
    ]
    case = replace(good.case, file=structs.replace(good.case.file, results=results))
    run = replace(good, case=case, rows=tuple(result_row(case, each.key, 0.5) for each in results))
    z, seconds = curves(run)[0][0], curves(good)[0][0]
    np.testing.assert_allclose(z.time, 1e3 * seconds.time, rtol=1e-12)
    assert z.allowed["z_peak"][0] == pytest.approx(1e3 * good.case.theory["t_peak"], rel=1e-12)
    drawn = histories.draw(run, "h", [z], "solver")
    assert "Time (ms)" in drawn
    assert "100.445 ms" in drawn
    assert "0.100445 s" in histories.draw(good, "h", [seconds], "solver")
