from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

from vmharness.backends import backend
from vmharness.case import CaseError, read
from vmharness.case.format import Within
from vmharness.formula import Formula
from vmharness.report.sections import sweep as page
from vmharness.run import run
from vmharness.studies.measured import measured
from vmharness.studies.sweep.runs import points, record, settings

BALL = Path(__file__).parents[2] / "cases" / "VM-061"
COARSE = "E/(1 - nu^2)*(t_peak/(500*0.9*L))^2"  # 500 steps to the lowest point


@pytest.fixture
def case():
    """VM-061, swept in large steps with tolerances for them."""
    case = read(BALL)
    coarse = replace(case, formulas={**case.formulas, "sweep rho": Formula(COARSE)})
    return planned(coarse, ranges={"k": (1000.0, 4000.0), "h": (0.5, 2.0), "g": (200.0, 800.0)})


def planned(case, **changes):
    plan = msgspec.structs.replace(case.file.sweep, **changes)
    return replace(case, file=msgspec.structs.replace(case.file, sweep=plan))


def gathered(variants, what):
    return [measured(run(variant.case, backend("builtin"))) for variant in variants]


def study(case, count=5):
    chosen, how = points(case, count, 0, None)
    return record(case, chosen, how, gathered)


def loose(case):
    """With tolerances of 0.1 %, which are wide for the steps of this test and narrow for a wrong formula."""
    results = [
        msgspec.structs.replace(result, tolerance=msgspec.structs.replace(result.tolerance, relative=1e-3))
        for result in case.file.results
    ]
    return replace(case, file=msgspec.structs.replace(case.file, results=results))


def test_formulas_that_are_right_hold_everywhere(case):
    found = study(loose(case))
    assert found.points == 5
    assert found.failed == []
    assert found.failing is None
    assert found.unjudged == {}
    for result in found.results:
        assert 0.0 <= result.share < 1.0
        assert result.share == pytest.approx(max(found.shares[result.key]), rel=1e-3)


def test_a_formula_that_is_right_at_one_point_only_is_caught(case):
    """Without the static deflection under sqrt(): right by chance with the number put in its place, for these data."""
    case = loose(case)
    own = case.theory["z_peak"]
    assert case.target("z_peak") == own
    wrong = f"-(h + v0/omega*{(-own - case.given['h']) * case.theory['omega'] / case.theory['v0']!r})"
    chance = replace(case, formulas={**case.formulas, "target z_peak": Formula(wrong)})
    assert chance.target("z_peak") == pytest.approx(own, rel=1e-12)

    found = study(chance)
    assert len(found.failed) >= 4
    by_key = {result.key: result for result in found.results}
    assert by_key["z_peak"].failed >= 4
    assert by_key["t_impact"].failed == 0
    assert len(found.failing.simpler) == 1
    assert found.failing.again.startswith(f"vm run VM-061 --set {next(iter(found.failing.simpler))}=")
    assert "--set rho=" in found.failing.again
    assert found.failing.why.startswith("z_peak: ")


def test_a_point_at_which_theory_has_no_value_cannot_be_judged(case):
    chosen = [{"k": 1000.0, "h": -1.0, "g": 386.0}, {"k": 1000.0, "h": 1.0, "g": 386.0}]
    found = record(loose(case), chosen, "two points", gathered)
    assert list(found.unjudged) == [0]
    assert "[theory] t_impact" in found.unjudged[0]
    assert found.failed == []
    assert "could not be judged" in page.verdict(found)


def test_constraints_hold_at_every_point(case):
    narrow = replace(case, formulas={**case.formulas, "within 1": Formula("g/386")})
    limit = msgspec.structs.replace(case.file.sweep.within[0], low=1.0, high=1.5)
    chosen, _ = points(planned(narrow, within=[limit]), 20, 0, None)
    assert len(chosen) == 20
    assert all(386.0 <= point["g"] <= 579.0 for point in chosen)
    never = planned(narrow, within=[msgspec.structs.replace(limit, low=-2.0, high=-1.0)])
    with pytest.raises(CaseError, match="no point of the region meets the constraints"):
        points(never, 5, 0, None)


def test_data_that_follow_are_set_with_the_point(case):
    there = settings(case, {"k": 1000.0, "h": 1.0, "g": 386.0})
    assert list(there) == ["k", "h", "g", "rho"]
    assert settings(case, {})["rho"] != there["rho"]


def test_the_section_of_the_page(case):
    found = study(loose(case), 3)
    section = page.section(msgspec.json.encode(found), case)
    assert section.summary.startswith("3 of 3 points pass, ")
    assert page.figures(msgspec.json.encode(found))[0].svg.startswith("<svg")
    assert section.tables[0].head[:3] == ["Result", "Points failed", "Largest share"]
    assert "k from 1000 to 4000 lbf/in" in section.text[0]


def test_a_grid_that_nobody_could_run_is_refused(case):
    assert len(points(case, None, 0, 3)[0]) <= 27
    with pytest.raises(CaseError, match=r"VM-061: a grid of 400 values of 3 data has 6.4e\+07 points"):
        points(case, None, 0, 400)


def test_a_case_that_declares_no_region_says_so(case):
    without = replace(case, file=msgspec.structs.replace(case.file, sweep=None))
    with pytest.raises(CaseError, match=r"VM-061: case.toml has no \[sweep\] table"):
        points(without, 5, 0, None)


def test_a_constraint_keeps_points_without_theory_out(case):
    """A height below nothing has no time of fall, but its own constraint has a value there."""
    above = Within(formula="h/L", low=0.1, high=10.0, because="the ball falls")
    plan = planned(case, ranges={"h": (-1.0, 1.0)}, within=[above])
    plan = replace(plan, formulas={**plan.formulas, "within 1": Formula(above.formula)})
    chosen, _ = points(plan, 8, 0, None)
    assert len(chosen) == 8
    assert min(point["h"] for point in chosen) > 0.0
