"""The deck of a case as the built-in solver reads it."""

import hashlib
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import vmharness
from vmharness.backends import builtin
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.explicit.watch import Watch
from vmharness.run import run
from vmharness.suite.export import exported
from vmharness.suite.outcome import Outcome, Status
from vmharness.suite.select import entry
from vmharness.suite.timed import Began

BALL = Path(__file__).parents[2] / "cases" / "VM-061"
GRAVITY = "*LOAD_BODY_Z\n$#    lcid        sf    lciddr        xc        yc        zc\n         1        &G\n"


@pytest.fixture
def including(tmp_path):
    """Makes a copy of the case whose deck includes its gravity from a file of the given name."""

    def case(name, *lines):
        folder = shutil.copytree(BALL, tmp_path / "VM-061")
        deck = (folder / "deck.k").read_text()
        assert GRAVITY in deck
        coarse = deck.replace("RRHO         7.3E-4", "RRHO         2.5437")
        (folder / "deck.k").write_text(coarse.replace(GRAVITY, f"*INCLUDE\n{name}\n"))
        (folder / name).write_text(GRAVITY)
        text = (folder / "case.toml").read_text()
        (folder / "case.toml").write_text(text.replace("[deck]\n", "\n".join(["[deck]", *lines, ""])))
        return read(folder)

    return case


def test_a_file_outside_the_case_is_included_only_if_the_case_allows_it(including, tmp_path):
    assert "lies outside the deck's folder" in run(including("../gravity.k"), builtin).reason
    shutil.rmtree(tmp_path / "VM-061")
    allowed = run(including("../gravity.k", "include_outside = true"), builtin)
    assert allowed.reason == ""
    digest = hashlib.sha256(GRAVITY.encode()).hexdigest()
    assert allowed.included == {"../gravity.k": digest}


def test_a_case_with_an_energy_that_cannot_be_is_an_error_with_its_values(including, monkeypatch):
    case = including("gravity.k")
    assert run(case, builtin).verdict is not Verdict.ERROR
    monkeypatch.setattr(Watch, "impossible", lambda watch: "the run cannot be judged: made for this test")
    judged = run(case, builtin)
    assert judged.verdict is Verdict.ERROR
    assert judged.reason == "the run cannot be judged: made for this test"
    assert all(row.comparison.value == row.comparison.value for row in judged.rows)


def test_the_hash_of_every_included_file_is_on_the_page_and_in_junit(including, tmp_path):
    from vmharness.report import render, write_case

    judged = run(including("gravity.k"), builtin)
    assert judged.reason == ""
    digest = hashlib.sha256(GRAVITY.encode()).hexdigest()
    write_case(judged, tmp_path / "reports")
    for name in ("README.md", "index.html"):
        text = (tmp_path / "reports" / "VM-061" / name).read_text()
        assert digest in text
        assert judged.deck_sha256 in text
    outcome = Outcome(judged.case.id, Status.PASS, run=judged)
    results = exported(
        [outcome], [entry(judged.case.folder)], "builtin", Began(["vm"], "2026-01-31T09:30:00Z", 0.0)
    )
    assert f'name="gravity.k.sha256" value="{digest}"' in render("junit", results)


def test_its_version_is_known_without_its_compiler():
    code = "import sys, vmharness.backends as b; print(b.backend('builtin').found().version, 'numba' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == [vmharness.__version__, "False"]
