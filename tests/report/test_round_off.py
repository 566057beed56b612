"""Pages on other machines: numbers with other last bits make the same text."""

import json
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from vmharness.case import read
from vmharness.compare import Tolerance, compare
from vmharness.formula import Formula
from vmharness.report import records, wording, write_case
from vmharness.report.figures import model
from vmharness.result import CaseRun, Solution
from vmharness.studies.sensitivity import sensitivities, smallest_seen

CASES = Path(__file__).parents[2] / "cases"
TIED = [
    "D-29",
    "D-37",
    "D-40",
    "D-43",
    "D-49",
    "D-59",
    "VM-084",
    "VM-156",
]  # theory makes numbers of theirs equal
NOISE = 1e-13  # relative: some hundred times the round-off of one operation


@pytest.fixture
def other_machine(monkeypatch):
    """A function of a seed, after which every formula has other last bits, anew at each evaluation."""
    evaluate = Formula.evaluate

    def use(seed):
        generator = np.random.default_rng(seed)

        def noisy(formula, values):
            found = evaluate(formula, values)
            return found * (1.0 + NOISE * generator.uniform(-1.0, 1.0, np.shape(found)))

        monkeypatch.setattr(Formula, "evaluate", noisy)

    return use


@pytest.fixture
def page(tmp_path, result_row):
    """A function that makes Markdown of a run in which every result uses 37 % of its tolerance, but for `noise`."""

    def made(id, noise=lambda: 0.0):
        case = read(CASES / id)
        rows = tuple(result_row(case, result.key, 0.372159 * (1.0 + noise())) for result in case.file.results)
        run = CaseRun(case, Solution("vmharness 9.9.9", None), rows, {}, {}, "d" * 64, "c" * 64, 1.0)
        write_case(run, tmp_path)
        return (tmp_path / id / "README.md").read_text()

    return made


@pytest.mark.parametrize("id", TIED)
def test_a_page_is_the_same_text_on_another_machine(id, page, other_machine):
    here = page(id)
    first = read(CASES / id).file.results[0].key
    assert f"{first} uses the largest share of its tolerance, 37 %" in here
    for seed in range(2):
        other_machine(seed)
        generator = np.random.default_rng(seed)
        assert page(id, lambda g=generator: 1e-7 * g.uniform(-1.0, 1.0)) == here


def test_of_equal_faults_the_first_result_sees_the_smallest(other_machine):
    for seed in range(5):
        other_machine(seed)
        found = sensitivities(read(CASES / "D-59"))
        assert smallest_seen(found["rho"]) == ("t_down", pytest.approx(0.6, rel=1e-7))


def test_what_is_at_equal_depth_is_painted_in_one_order(good):
    n = np.arange(27).reshape(3, 3, 3)  # 2 x 2 x 2 cubes between 3 x 3 x 3 nodes
    corners = [
        n[i : i + 2, j : j + 2, k : k + 2].ravel()[[0, 4, 6, 2, 1, 5, 7, 3]]
        for i, j, k in np.ndindex(2, 2, 2)
    ]
    x = 0.1 * np.array(list(np.ndindex(3, 3, 3)))
    view = replace(good.solution.view, ids=n.ravel() + 1, x=x, solids=np.array(corners))
    noise = 1.0 + NOISE * np.random.default_rng(0).uniform(-1.0, 1.0, x.shape)
    assert model.draw(replace(view, x=x * noise), "cubes", "m/s2") == model.draw(view, "cubes", "m/s2")


def at(row, difference, tolerance):
    """The row with a target of one, a value `difference` away, and this tolerance."""
    return replace(row, comparison=compare(1.0, 1.0 + difference, Tolerance(relative=tolerance)))


def test_a_share_that_is_round_off_is_called_so(good):
    row = good.rows[0]
    assert wording.used(at(row, 3e-13, 5e-12)) == "round-off"
    assert wording.used(at(row, 3e-12, 5e-12)) == "60 %"
    assert wording.used(at(row, 3e-13, 1e-6)) == "<1 %"  # it is, whatever the last bits
    exact = replace(good, rows=tuple(at(row, 3e-13, 5e-12) for row in good.rows))
    assert wording.summary(exact).endswith(
        "within their tolerances. Their differences from theory are round-off."
    )


def test_a_verdict_is_of_all_digits(good):
    assert at(good.rows[0], 3e-13, 2e-13).verdict == "fail"


@dataclass(frozen=True)
class Record:
    """What a study might leave."""

    values: list[float | None]
    count: int


def test_a_record_has_no_digits_of_one_machine(tmp_path):
    written = [
        records.write(tmp_path, "A", name, Record([0.1 + last, None, 1e300], 3))
        for name, last in (("here", 0.0), ("there", 3e-17))
    ]
    assert written[0].read_bytes() == written[1].read_bytes()
    assert json.loads(written[0].read_text()) == {"values": [0.1, None, 1e300], "count": 3}
