import re
from pathlib import Path

import pytest

from vmharness.case import read
from vmharness.case.tolerance import allowed, budget, review, review_measured

BALL = Path(__file__).parents[2] / "cases" / "VM-061"


@pytest.fixture
def changed(tmp_path):
    """Reads the case with text of its file replaced."""

    def read_changed(pattern, replacement, count=1):
        text = (BALL / "case.toml").read_text()
        text, found = re.subn(pattern, replacement, text, count=count, flags=re.S)
        assert found
        (tmp_path / "case.toml").write_text(text)
        for name in ("deck.k", "schematic.svg", "post.cfile"):
            (tmp_path / name).write_bytes((BALL / name).read_bytes())
        return read(tmp_path)

    return read_changed


def of(sentences, key):
    return [sentence for sentence in sentences if sentence.startswith(f"{key}:")]


def test_no_tolerance_of_the_manual_is_tighter_or_much_looser_than_its_budget():
    assert review(read(BALL)) == ([], [])


def test_a_budget_is_the_sum_of_its_lines(changed):
    case = changed(r"\[\[budget\]\].*(?=\[\[published\]\])", """
[[budget]]
source = "a"
because = "b"
relative = { t_peak = 1e-6, z_peak = "2e-6" }
[[budget]]
source = "c"
because = "d"
relative = { t_peak = "3e-6" }
""")  # fmt: skip
    assert budget(case, "t_peak") == pytest.approx(4e-6, rel=1e-12)
    assert budget(case, "z_peak") == pytest.approx(2e-6, rel=1e-12)
    assert budget(case, "t_impact") is None
    tight, loose = review(case)
    assert not tight
    assert of(loose, "t_impact") == ["t_impact: no error budget gives a reason for the tolerance, 5e-07"]
    assert not of(loose, "t_peak")


def test_a_loose_tolerance_is_doubtful(changed):
    tight, loose = review(changed(r"relative = 5e-7", "relative = 0.01"))
    assert not tight
    assert re.fullmatch(
        r"t_impact: the tolerance, 0.01, is more than 10 times the budget, \S+", *of(loose, "t_impact")
    )


def test_a_budget_above_the_tolerance_is_wrong(changed):
    tight, loose = review(changed(r"relative = 5e-7", "relative = 1e-12"))
    assert not loose
    assert re.fullmatch(
        r"t_impact: the error budget, \S+, exceeds the tolerance, 1e-12", *of(tight, "t_impact")
    )


def test_an_absolute_tolerance_counts_as_the_fraction_that_it_is(changed):
    case = changed(r'(key\s*= "z_peak".*?)relative = \S+,', r"\1relative = 1e-6, absolute = 0.5,")
    assert allowed(case, "z_peak") == pytest.approx(1e-6 + 0.5 / abs(case.target("z_peak")), rel=1e-12)


def test_an_error_that_its_budget_does_not_explain_is_said():
    case = read(BALL)
    expected = budget(case, "t_peak")
    assert review_measured(case, {"t_peak": -0.99 * expected, "z_peak": 0.0}) == []
    (sentence,) = review_measured(case, {"t_peak": -1.01 * expected})
    assert re.fullmatch(r"t_peak: the measured error, \S+, exceeds the error budget, \S+", sentence)


def test_the_budget_of_a_target_of_zero_is_in_the_unit_of_the_result(changed):
    zero = changed(
        r'(key\s*= "z_impact".*?target\s*= )"z_impact"(.*?)\{ relative = \S+,',
        r'\1"h - h"\2{ absolute = 1e-4,',
    )
    assert zero.target("z_impact") == 0.0
    expected = budget(zero, "z_impact")
    assert allowed(zero, "z_impact") == pytest.approx(1e-4, rel=1e-12)
    assert re.fullmatch(
        f"z_impact: the tolerance, 0.0001, is more than 10 times the budget, {expected:.2g}",
        *of(review(zero)[1], "z_impact"),
    )
    tight = changed(
        r'(key\s*= "z_impact".*?target\s*= )"z_impact"(.*?)\{ relative = \S+,',
        r'\1"h - h"\2{ absolute = 1e-9,',
    )
    assert of(review(tight)[0], "z_impact")
