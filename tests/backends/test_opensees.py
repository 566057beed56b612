"""OpenSees runs the decks of the manual that it can represent, and is judged by the same theory."""

import os
from importlib import util
from pathlib import Path

import pytest

from vmharness.backends import backend, opensees
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.run import run
from vmharness.suite.outcome import Status, exit_code

CASES = Path(__file__).parents[2] / "cases"
INSTALLED = util.find_spec("openseespy") is not None
REQUIRED = "VMHARNESS_SOLVERS" in os.environ  # where every solver must be there, a missing one is a failure

installed = pytest.mark.skipif(not (INSTALLED or REQUIRED), reason=opensees.INSTALL)


@installed
@pytest.mark.parametrize(
    "id", ["VM-071", "VM-072", "VM-075", "VM-080", "VM-091", "VM-156", "VM-182", "D-37", "D-44", "VM-084"]
)
def test_it_agrees_with_theory_as_closely_as_the_built_in_solver_must(id, tmp_path):
    found = run(read(CASES / id), backend("opensees"), folder=tmp_path)
    assert found.verdict is Verdict.PASS, found.reason
    assert {row.verdict for row in found.rows} <= {Verdict.PASS, Verdict.UNREPORTED}
    assert "central differences" in found.solution.facts["Integrator"]


@installed
def test_what_it_does_not_report_is_counted_as_that(tmp_path):
    found = run(read(CASES / "D-37"), backend("opensees"), folder=tmp_path)
    assert [row.key for row in found.unreported] == ["strain_2"]
    assert "energy 'internal'" in found.unreported[0].comparison.reason


@installed
@pytest.mark.parametrize("name", ["F", "E"])
def test_a_wrong_datum_in_the_deck_fails(name, tmp_path):
    case = read(CASES / "D-37")
    wrong = case.with_deck_of({name: 1.02 * case.datum(name)})
    found = run(wrong, backend("opensees"), folder=tmp_path)
    assert found.verdict is Verdict.FAIL


def test_a_problem_that_it_cannot_pose_is_neither_a_pass_nor_a_failure(tmp_path):
    found = run(read(CASES / "VM-061"), backend("opensees"), folder=tmp_path)
    if not found.solution.unrepresentable:
        pytest.skip(found.reason)  # it is not installed
    assert {row.verdict for row in found.rows} == {Verdict.UNREPRESENTABLE} == {found.verdict}
    assert "*CONTACT_NODES_TO_SURFACE_ID: the keyword is not supported" in found.reason
    assert exit_code([Status.UNREPRESENTABLE]) == 6
    assert exit_code([Status.PASS, Status.UNREPRESENTABLE]) == 0
    assert exit_code([Status.FAIL, Status.UNREPRESENTABLE]) == 1


def test_it_says_how_to_install_what_is_missing(monkeypatch):
    monkeypatch.setattr(util, "find_spec", lambda name: None)
    assert "pip install 'vmharness[opensees]'" in opensees.found().missing
