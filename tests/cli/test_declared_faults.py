"""Every fault that the case declares, written into its deck, makes the command exit with 1."""

import json
import re
from pathlib import Path

import pytest

from vmharness.case import read
from vmharness.studies.faults.declared import faulty_data

CASE = read(Path(__file__).parents[2] / "cases" / "VM-061")
WIDTH = 10  # of a field of *PARAMETER


def in_field(value):
    """As many digits as fit."""
    texts = (f"{value:.{digits}g}" for digits in range(WIDTH, 0, -1))
    return next(text for text in texts if len(text) <= WIDTH).rjust(WIDTH)


def test_the_deck_that_the_faults_are_written_into_passes(ball, vm_process):
    ball()
    process = vm_process("run", "VM-061", "--no-report")
    out, err = process.communicate()
    assert process.returncode == 0, out + err


@pytest.mark.parametrize("fault", CASE.file.faults, ids=lambda fault: fault.text)
def test_a_planted_fault_is_1(ball, vm_process, fault):
    path = ball() / "deck.k"
    deck = path.read_text()
    for name, value in CASE.with_deck_of(faulty_data(CASE, fault)).deck_parameters().items():
        deck, found = re.subn(
            rf"(?<![A-Z])R{name:<{WIDTH - 1}}.{{1,{WIDTH}}}", f"R{name:<{WIDTH - 1}}{in_field(value)}", deck
        )
        assert found == 1, name
    path.write_text(deck)
    process = vm_process("run", "VM-061", "--no-report", "--json", "r.json")
    out, err = process.communicate()
    assert process.returncode == 1, out + err
    (case,) = json.loads(Path("r.json").read_text())["cases"]
    failed = {row["key"] for row in case["results"] if row["verdict"] == "fail"}
    assert failed >= set(fault.must_fail)
