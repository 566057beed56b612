"""Pages on other machines: numbers with other last bits make the same text."""

from pathlib import Path

import numpy as np
import pytest

from vmharness.case import read
from vmharness.evidence.sensitivity import sensitivities, smallest_seen
from vmharness.formula import Formula
from vmharness.report import write_case
from vmharness.result import CaseRun, Solution

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
    assert f"{first} uses the most of its own, 37 %" in here
    for seed in range(3):
        other_machine(seed)
        generator = np.random.default_rng(seed)
        assert page(id, lambda g=generator: 1e-7 * g.uniform(-1.0, 1.0)) == here


def test_of_equal_faults_the_first_result_sees_the_smallest(other_machine):
    for seed in range(5):
        other_machine(seed)
        found = sensitivities(read(CASES / "D-59"))
        assert smallest_seen(found["rho"]) == ("t_down", pytest.approx(0.6, rel=1e-7))
