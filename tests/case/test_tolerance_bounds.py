"""Bounds of tolerances and budgets: no solver could hold finer ones, every solver would pass with coarser ones."""

import pytest

from vmharness.case import CaseError, read
from vmharness.case.bounds import FINEST, scale

RELATIVE = "{ relative = 1e-6,"
AT_REST = (  # a target of zero, beside the displacement of 1.226 m
    'target    = "z_T"',
    'target    = "0*z_T"',
)


@pytest.mark.parametrize(
    ("tolerance", "message"),
    [
        ("relative = 1e300", r"\[results\] 1: relative = 1e\+300: it must be below the size itself"),
        ("relative = 1.0", r"relative = 1: it must be below the size itself: a result of zero, .* would pass"),
        ("relative = 5e-324", r"relative = 4.94066e-324: at least 2.2e-15 of the size .* 64 bits"),
        ("relative = 2e-15", r"relative = 2e-15: at least 2.2e-15"),
        ("relative = inf", r"\[results\] 1: tolerance: relative: inf is not a finite number"),
        ("relative = nan", r"\[results\].*tolerance"),
        ("relative = 1e-6, absolute = nan", r"\[results\].*tolerance"),
        ("absolute = inf", r"\[results\] 1: tolerance: absolute: inf is not a finite number"),
        ("absolute = 1e300", r"\[results\] 1: the tolerance, 1e\+300, of a quantity of the size 1.226 m: it must be below"),
        ("absolute = 1.3", r"the tolerance, 1.3, of a quantity of the size 1.226 m"),
        ("absolute = 5e-324", r"the tolerance, 4.94066e-324, of a quantity of the size 1.226 m: at least 2.2e-15"),
        ("relative = 0.6, absolute = 0.8", r"the tolerance, 1.53575, of a quantity"),
    ],
)  # fmt: skip
def test_a_tolerance_that_means_nothing_is_refused(fall, tolerance, message):
    with pytest.raises(CaseError, match=message):
        read(fall((RELATIVE, f"{{ {tolerance},")))


@pytest.mark.parametrize(
    "tolerance", ["relative = 0.99", f"relative = {FINEST!r}", "absolute = 1.2", "absolute = 1e-14"]
)
def test_a_tolerance_within_the_bounds_is_accepted(fall, tolerance):
    assert read(fall((RELATIVE, f"{{ {tolerance},"))).target("z_T") == pytest.approx(-1.22625)


def test_a_target_of_zero_has_the_size_of_its_unit(fall):
    case = read(fall(AT_REST, (RELATIVE, "{ absolute = 1e-9,")))
    assert scale(case, "z_T") == pytest.approx(1.22625)  # the line of theory z_T is the only length
    with pytest.raises(CaseError, match=r"the tolerance, 2, of a quantity of the size 1.226 m"):
        read(fall(AT_REST, (RELATIVE, "{ absolute = 2.0,"), id="loose"))
    with pytest.raises(CaseError, match="only an absolute tolerance can judge it"):
        read(fall(AT_REST, id="relative"))


def test_nothing_says_how_large_a_result_without_relatives_is(fall):
    momentum = ('target    = "z_T"\nunit      = "m"', 'target    = "0*m^2*g"\nunit      = "kg-N"')
    with pytest.raises(CaseError, match=r"no datum, line of theory or other target is in kg-N"):
        read(fall(momentum, (RELATIVE, "{ absolute = 1e300,")))


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("z_T = -5e-7", r"\[budget\] 1: z_T: -5e-07 is negative"),
        ("z_T = 1.0", r"\[budget\] 1: z_T: 1 is not below 1"),
        ('z_T = "m/m*1e200"', r"\[budget\] 1: z_T: 1e\+200 is not below 1"),
        ("z_T = inf", r"\[budget\] 1: relative: z_T: inf is not a finite number"),
        ("z_T = nan", r"\[budget\] 1: relative: z_T: nan is not a finite number"),
    ],
)
def test_an_error_budget_is_of_small_errors(fall, line, message):
    with pytest.raises(CaseError, match=message):
        read(fall(("z_T = 5e-7", line)))


@pytest.mark.parametrize(
    ("given", "place"),
    [("value = 2.0", r"\[given\] m: value"), ("value = 9.81", r"\[given\] g: value")],
)
@pytest.mark.parametrize("number", ["inf", "-inf", "nan", "1e999"])
def test_all_data_are_finite(fall, given, place, number):
    with pytest.raises(CaseError, match=place + ": .* is not a finite number"):
        read(fall((given, f"value = {number}")))


def test_orders_of_accuracy_are_those_of_methods(fall):
    study = """
[converge]
refined = "time step"
levels  = [1, 2, 4]
size    = "T/N"
set     = { g = "g*N/N" }
orders  = { z_T = ORDER }
because = "central differences"
"""
    assert read(fall(("[deck]\n", study.replace("ORDER", "2") + "[deck]\n"))).file.converge.orders == {
        "z_T": 2.0
    }
    for order in ("1e300", "inf", "nan", "5e-324"):
        with pytest.raises(CaseError, match=r"\[converge\]"):
            read(fall(("[deck]\n", study.replace("ORDER", order) + "[deck]\n"), id=f"order{order}"))
