from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

from vmharness.case import CaseError, read
from vmharness.report.sections import converge as page
from vmharness.studies.converge.richardson import Kind
from vmharness.studies.converge.runs import record, variants
from vmharness.studies.gather import gather
from vmharness.studies.measured import Measured, Value

BALL = Path(__file__).parents[2] / "cases" / "VM-061"


def planned(case, **changes):
    """The case with another plan, of which N is the number of steps to the impact."""
    plan = msgspec.structs.replace(case.file.converge, **changes)
    return replace(case, file=msgspec.structs.replace(case.file, converge=plan))


def study(case):
    found = {n: event for n, event in gather(variants(case)) if isinstance(event, Measured)}
    return record(case, [found[n] for n in range(len(found))])


def measured(case, error):
    """Outcomes as of a solver whose relative error at the size h is `error`(h)."""
    sizes = [1 / (n + 0.2) for n in case.file.converge.levels]
    return [
        Measured({key: Value(1.0, case.target(key) * (1 + error(h)), 0.0, "pass") for key in KEYS})
        for h in sizes
    ]


KEYS = ("t_impact", "z_impact", "v_impact", "ke_impact", "t_peak", "z_peak")


@pytest.fixture
def short(ball):
    return planned(replace(ball, deck_text=""), levels=[45, 90, 180, 360])


def test_the_ball_is_of_second_order_when_the_phase_of_its_impact_is_held(store, short):
    found = study(short)
    by_key = {result.key: result for result in found.results}
    assert by_key["z_peak"].found.order == pytest.approx(2.0, abs=0.02)
    assert by_key["t_impact"].found.order == pytest.approx(3.0, abs=0.02)
    assert all(result.agrees and result.inside for result in found.results)
    assert [level.cycles for level in found.levels] == sorted(level.cycles for level in found.levels)
    assert found.levels[0].data["rho"] == pytest.approx(2.5437 * (found.levels[0].size / 1e-4) ** 2, rel=1e-3)


def test_halving_its_step_alone_is_not_asymptotic(store, short):
    halved = planned(short, levels=[1, 2, 4, 8, 16])
    formula = type(short.formulas["t_impact"])
    rho, size = "2.5437*rho/7.3e-4*(5/N)^2", "5*dt/N"
    halved = replace(
        halved, formulas={**short.formulas, "converge rho": formula(rho), "converge size": formula(size)}
    )
    found = {result.key: result for result in study(halved).results}["z_peak"]
    assert found.found.kind is Kind.NOT_ASYMPTOTIC
    assert found.found.order is None
    assert found.agrees is False


def test_a_solver_of_the_first_order_does_not_agree_with_a_promised_second(short):
    found = record(short, measured(short, lambda h: 0.3 * h))
    assert [result.found.order for result in found.results] == pytest.approx([1.0] * 6)
    assert not any(result.agrees for result in found.results)
    assert page.summary(found) == "an order is too low"


def test_a_solver_that_converges_to_something_else_leaves_theory_outside(short):
    found = record(short, measured(short, lambda h: 1e-3 + 0.3 * h**3))
    assert all(result.agrees for result in found.results)
    assert not any(result.inside for result in found.results)


def test_exact_is_what_no_level_moves(short):
    found = record(short, measured(short, lambda h: 0.0))
    assert {result.found.kind for result in found.results} == {Kind.EXACT}
    assert all(result.agrees and result.inside for result in found.results)
    assert page.summary(found) == "exact"


def test_a_level_that_fails_is_said(short):
    outcomes = measured(short, lambda h: h**2)
    outcomes[2] = Measured(failure="diverged")
    found = record(short, outcomes)
    assert {result.found.kind for result in found.results} == {Kind.NO_VALUE}
    assert "N = 180: diverged." in page.remarks(found)


def test_the_section_of_the_page(short):
    found = record(short, measured(short, lambda h: 0.3 * h**3))
    section = page.section(msgspec.json.encode(found), short)
    assert section.summary == "order 3.0"
    orders = section.tables[1]
    assert orders.rows[0][:3] == ["t_impact", "3.00 ± 0.00", "3"]
    assert page.figures(msgspec.json.encode(found))[0].svg.startswith("<svg")
    assert section == page.section(msgspec.json.encode(found), short)


def test_levels_that_move_a_target_are_refused(short):
    moved = replace(
        short, formulas={**short.formulas, "converge rho": type(short.formulas["t_impact"])("rho*N")}
    )
    moved = planned(moved, set={"rho": "rho*N", "k": "k*N"})
    moved = replace(moved, formulas={**moved.formulas, "converge k": type(short.formulas["t_impact"])("k*N")})
    with pytest.raises(CaseError, match=r"VM-061: \[converge\] N = 45 changes the target of t_peak"):
        variants(moved)


def test_a_case_that_plans_no_refinement_says_so():
    ball = read(BALL)
    case = replace(ball, file=msgspec.structs.replace(ball.file, converge=None))
    with pytest.raises(CaseError, match=r"VM-061: case.toml has no \[converge\] table"):
        variants(case)


def test_what_has_no_order_is_not_called_exact(short):
    wild = planned(short, orders={})
    found = record(wild, measured(short, lambda h: (-1) ** round(1 / h) * h))
    assert {result.found.kind for result in found.results} <= {
        Kind.OSCILLATES,
        Kind.NOT_ASYMPTOTIC,
        Kind.DIVERGES,
    }
    assert page.summary(found) == "no order"
