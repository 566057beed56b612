import shutil
import tempfile
from dataclasses import replace
from pathlib import Path

import pytest

from vmharness.backends import identity
from vmharness.case import read
from vmharness.studies.gather import gather, keep, kept, kept_file
from vmharness.studies.measured import Measured
from vmharness.studies.sources import sources
from vmharness.studies.variant import Variant


def outcomes(variants, **options):
    found = {}
    for number, event in gather(variants, **options):
        if isinstance(event, Measured):
            assert number not in found
            found[number] = event
    return [found[number] for number in range(len(variants))]


def test_variants_are_measured_once_each_and_then_read_from_disk(store, ball):
    heavy = ball.with_deck(ball.deck_text.replace("RM              0.5", "RM              0.6"))
    variants = [Variant(ball), Variant(heavy, "heavy"), Variant(ball, "again")]
    first = outcomes(variants, jobs=2)
    assert [outcome.passed for outcome in first] == [True, False, True]
    assert first[0] is first[2]
    assert not first[0].cached
    ke = first[1].results["ke_impact"]
    assert ke.error == pytest.approx(0.2, rel=1e-3)  # m v^2/2
    assert first[1].worst[1] > 1e3
    again = outcomes(variants)
    assert [outcome.cached for outcome in again] == [True, True, True]
    assert again == [replace(outcome, cached=True) for outcome in first]


def test_an_interrupted_study_keeps_what_is_done(store, ball):
    variants = [Variant(ball), Variant(ball.with_deck("*KEYWORD\n*END\n"))]
    running = gather(variants)
    number = next(number for number, event in running if isinstance(event, Measured))
    running.close()
    found = dict(event for event in gather(variants) if isinstance(event[1], Measured))
    assert found[number].cached
    assert not found[1 - number].cached
    assert "no *NODE in the deck" in found[1].failure


OTHER = """
from vmharness.backends.protocol import Found

NAME = "Other"
review = reports = solve = None

def found():
    return Found(version="1.0")
"""


def test_what_the_outcome_depends_on_is_in_the_key(ball, installed):
    installed("other", OTHER)

    def key(case, solver="builtin", fault=""):
        return Variant(case, "any", fault).key(solver)

    case = replace(ball, deck_text="")
    keys = [
        key(case),
        key(ball),
        key(case.with_given({"k": 2000.0})),
        key(case.with_deck_of({"k": 2000.0})),
        key(case, solver="other"),
        key(case, fault="mass doubled"),
    ]
    assert len(set(keys)) == len(keys)
    assert key(case) == Variant(case, "another label").key("builtin")


FAILS = """
from vmharness.backends.protocol import Found
from vmharness.execution.program import ProgramError

NAME = "Other"
review = reports = None

def found():
    return Found(version="1.0")

def solve(job):
    (job.folder / "messag").write_text("no licence")
    raise ProgramError("other failed, exit code 1")
"""


def test_the_failure_of_a_program_is_not_kept_and_no_files_of_it_are(ball, installed, tmp_path, monkeypatch):
    installed("other", FAILS)
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(temporary))
    outcomes = [event for _, event in gather([Variant(ball)], solver="other") if isinstance(event, Measured)]
    assert [outcome.failure for outcome in outcomes] == ["other failed, exit code 1"]
    assert outcomes[0].lost
    assert kept(Variant(ball).key("other")) is None
    assert not list(temporary.iterdir())


def test_the_version_of_a_solver_and_the_text_of_its_adapter_are_in_the_key(ball, installed):
    keys = []
    for source in (OTHER, OTHER.replace("1.0", "1.1"), OTHER + "FINER = True\n", OTHER):
        installed("other", source)
        keys.append(Variant(ball).key("other"))
    assert keys[0] == keys[3]
    assert len(set(keys)) == 3


def test_a_mesh_that_is_wrong_is_in_the_key(ball):
    bar = read(ball.folder.parent / "D-37")
    assert Variant(bar).key("builtin") != Variant(bar.with_deck_of({"n": 50.0})).key("builtin")


def test_the_sources_are_the_same_on_every_machine_and_outcomes_are_not(ball, monkeypatch):
    here, known = sources(), Variant(ball).key("builtin")
    monkeypatch.setattr("vmharness.explicit.kernels.cache._processor", lambda: "model name: another")
    for cached in (sources, identity):
        cached.cache_clear()
    assert sources() == here
    assert Variant(ball).key("builtin") != known
    identity.cache_clear()


def test_a_file_of_the_case_that_changes_is_in_the_key_unless_it_is_prose(ball, tmp_path):
    folder = Path(shutil.copytree(ball.folder, tmp_path / "VM-061"))
    key = Variant(read(folder)).key("builtin")
    (folder / "README.md").write_text("# Other prose")
    assert Variant(read(folder)).key("builtin") == key
    (folder / "deck.k").write_text((folder / "deck.k").read_text() + "$ a comment\n")
    assert Variant(read(folder)).key("builtin") != key


def test_files_elsewhere_that_a_deck_includes_are_in_the_key(ball, tmp_path):
    folder = Path(shutil.copytree(ball.folder, tmp_path / "VM-061"))
    (folder / "deck.k").write_text(
        (folder / "deck.k").read_text().replace("*END", "*INCLUDE\n../more.k\n*END")
    )
    toml = (
        (folder / "case.toml")
        .read_text()
        .replace('file = "deck.k"', 'file = "deck.k"\ninclude_outside = true')
    )
    (folder / "case.toml").write_text(toml)
    (tmp_path / "more.k").write_text("*KEYWORD\n*END\n")
    key = Variant(read(folder)).key("builtin")
    (tmp_path / "more.k").write_text("*KEYWORD\n$ more\n*END\n")
    assert Variant(read(folder)).key("builtin") != key


def test_an_outcome_that_cannot_be_read_is_not_there(store):
    keep("ab12", Measured(cycles=3))
    assert kept("ab12").cycles == 3
    kept_file("ab12").write_text("{")
    assert kept("ab12") is None


@pytest.mark.parametrize(
    "content", ["{}", '{"results": {}, "cycles": 5}', '{"results": {"z": ', "[" * 99_999, "[]"]
)
def test_a_file_that_is_no_outcome_of_the_variant_is_made_again(store, ball, content):
    path = kept_file(Variant(ball).key("builtin"))
    path.parent.mkdir(parents=True)
    path.write_text(content)
    (again,) = outcomes([Variant(ball)])
    assert again.passed
    assert not again.cached
    assert outcomes([Variant(ball)]) == [replace(again, cached=True)]


def test_a_fault_of_the_solver_is_planted_in_a_process_of_its_own(store, ball, work):
    clean, faulty = outcomes([Variant(ball), Variant(ball, fault="late")], plant=work.plant)
    assert clean.passed
    assert faulty.results["t_impact"].error == pytest.approx(1e-3, rel=1e-4)
    (after,) = outcomes([Variant(ball, fault="")], plant=work.plant)
    assert after == replace(clean, cached=True)


def test_a_fault_that_nothing_plants_is_said(store, ball):
    (outcome,) = outcomes([Variant(ball, fault="late")])
    assert outcome.failure == "defect: ValueError: nothing plants the fault late"
    assert not outcome.passed
