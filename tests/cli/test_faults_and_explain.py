"""`vm faults` and `vm explain`: what they say, what they leave for the page, their exit codes."""

import json
from pathlib import Path

import pytest

from vmharness.studies.faults import runs as faults

FEW = ("G +1 %", "RHO +1 %", "half_step_start")


@pytest.fixture
def few(monkeypatch):
    """Only a few of the faults are planted."""
    real = faults.all_faults
    monkeypatch.setattr(faults, "all_faults", lambda *of: [one for one in real(*of) if one.name in FEW])


def test_faults_are_scored_and_kept_for_the_page(ball, vm, here, few, monkeypatch):
    monkeypatch.setattr("vmharness.studies.gather.root", lambda: here / "cache")
    ball()
    code, out, _ = vm("faults", "VM-061", "-j", "1", "--json", "all.json")
    assert code == 0
    assert "planted faults: 3 runs" in out
    assert "These faults change no case: " in out
    record = json.loads((here / "reports" / "VM-061" / "studies" / "faults.json").read_text())
    by = {one["fault"]: one for one in record["findings"]}
    assert by["G +1 %"]["noticed"] == "caught"
    assert by["half_step_start"]["noticed"] == "caught"
    together = json.loads((here / "all.json").read_text())
    assert together["cases"] == [record]
    assert together["coverage"]["matrix"]["half_step_start"]["VM-061"] == by["half_step_start"]
    code, out, _ = vm("faults", "VM-061", "-j", "1")
    assert "3 runs, 3 of them from cache" in out
    assert vm("run", "VM-061")[0] == 0
    page = (here / "reports" / "VM-061" / "README.md").read_text()
    assert "## Planted faults" in page
    assert "| G |" in page
    assert (
        "| The first velocity is that of a whole step after the start, not of half a step (half_step_start) |"
        in page
    )


def test_a_case_that_fails_has_no_score(ball, vm, few):
    ball(**{"RG            386.0": "RG            387.0"})
    code, out, err = vm("faults", "VM-061", "-j", "1")
    assert code == 6
    assert "VM-061: the run without a fault does not pass: " in err
    assert "faults.json" not in out


def test_a_result_that_no_fault_changes_is_complained_of(ball, vm, few, monkeypatch):
    monkeypatch.setattr(faults, "unmoved", lambda sound, outcomes: ["z_impact"])
    monkeypatch.setattr(
        faults, "unproven", lambda case, outcomes: ["Ball too heavy: v must fail, and passes"]
    )
    ball()
    code, _, err = vm("faults", "VM-061", "-j", "1")
    assert code == 4
    assert (
        "VM-061: z_impact: no fault of deck or solver changes its value: this result cannot disagree" in err
    )
    assert vm("run", "VM-061")[0] == 0
    assert (
        "No fault of deck or solver changes the value of z_impact"
        in Path("reports/VM-061/README.md").read_text()
    )


def test_a_difference_is_explained_and_kept_for_the_page(ball, vm, here):
    ball()
    code, out, _ = vm("explain", "VM-061", "-j", "1")
    assert code == 0
    assert "rounding of the deck" in out
    assert "LS-DYNA: states 0.001 s apart" in out
    record = json.loads((here / "reports" / "VM-061" / "studies" / "explain.json").read_text())
    peak = next(one for one in record["results"] if one["key"] == "z_peak")
    parts = {part["cause"]: part["value"] for part in peak["parts"]}
    assert parts["rounding of the deck"] == pytest.approx(-5.3e-6, rel=0.02)
    assert vm("run", "VM-061")[0] == 0
    page = (here / "reports" / "VM-061" / "README.md").read_text()
    assert "## Causes of the error\n" in page
    assert "Of all ways of reading that were tried, the following one (states 0.001 s apart" in page
    assert (here / "reports" / "VM-061" / "explained.svg").read_text().startswith("<svg")


def test_what_cannot_be_explained_is_said(ball, vm):
    assert vm("explain", "VM-999")[0] == 4
    (ball() / "deck.k").write_text("*KEYWORD\n*END\n")
    code, _, err = vm("explain", "VM-061", "-j", "1")
    assert code == 4
    assert "the run of the unchanged case failed" in err
