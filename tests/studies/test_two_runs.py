import pytest

from vmharness.export import SCHEMA, Case, Machine, Result, Run
from vmharness.studies.compare import pairs

MACHINE = Machine(host="", system="", processor="", cores=1, python="3", packages={})


def result(key="z", value=-1.5, verdict="pass", target=-1.5):
    return Result(
        key=key, label="", event="", channel="z", unit="in", target=target, value=value, error=None,
        error_percent=None, tolerance=0.0015, tolerance_percent=0.1, share=None, verdict=verdict, reason="",
        published={},
    )  # fmt: skip


def run(*results, id="VM-1", verdict="pass", **data):
    case = Case(
        id=id, title="", folder=None, solver="a solver 1", set=data, outcome=verdict, verdict=verdict, reason="",
        started=None, seconds=None, cycles=None, facts={}, notes=[], sha256={}, inputs_sha256=None,
        results=list(results),
    )  # fmt: skip
    return of_cases(case)


def of_cases(*cases):
    return Run(
        schema=SCHEMA, version="0.1", command=["vm", "run"], started="2026-01-31T09:30:00Z", seconds=1.0,
        machine=MACHINE, solvers=[], counts={}, cases=list(cases),
    )  # fmt: skip


def test_equal_runs_differ_in_nothing():
    (pair,) = pairs(run(result()), run(result()))
    assert (pair.percent, pair.share, pair.worse, pair.remark) == (0.0, 0.0, False, "")


def test_a_difference_is_said_in_percent_of_the_target_and_of_the_tolerance():
    (pair,) = pairs(run(result(value=-1.5)), run(result(value=-1.50075)))
    assert pair.percent == pytest.approx(-0.05)
    assert pair.share == pytest.approx(0.5)
    assert not pair.worse


def test_a_worse_verdict_comes_first():
    first = run(result("a"), result("b"))
    second = run(result("a", value=-1.501), result("b", value=-1.5001, verdict="fail"))
    assert [pair.key for pair in pairs(first, second)] == ["b", "a"]
    assert pairs(first, second)[0].worse
    assert not any(pair.worse for pair in pairs(second, first))


def test_what_is_missing_is_worse_than_any_verdict():
    (pair,) = pairs(run(result(verdict="error")), of_cases())
    assert pair.verdicts == ("error", "missing")
    assert pair.worse
    (added,) = pairs(of_cases(), run(result(verdict="fail")))
    assert not added.worse


def test_a_case_without_results_is_not_lost():
    (pair,) = pairs(run(verdict="pass"), run(verdict="error"))
    assert (pair.key, pair.worse) == ("", True)


def test_another_target_is_said_and_other_data_are_another_case():
    (pair,) = pairs(run(result()), run(result(target=-1.6)))
    assert pair.remark == "the target is another"
    assert len(pairs(run(result()), run(result(), k=2000.0))) == 2


def test_a_target_of_zero_leaves_the_first_value_as_the_scale():
    (pair,) = pairs(run(result(value=2.0, target=0.0)), run(result(value=2.2, target=0.0)))
    assert pair.percent == pytest.approx(10.0)
    (nothing,) = pairs(run(result(value=None)), run(result()))
    assert nothing.percent is None
