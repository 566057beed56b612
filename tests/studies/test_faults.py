"""Planted faults: what they change, that they are caught, and that a blind case is said to be blind."""

import shutil
import time
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
import pytest

from vmharness.case import CaseError, read
from vmharness.case.deck import read_deck
from vmharness.studies.faults import deck_faults, plant
from vmharness.studies.faults.deck_faults import CaseFault
from vmharness.studies.faults.record import FaultsRecord, Noticed, coverage
from vmharness.studies.faults.runs import (
    StudyError,
    all_faults,
    finding,
    planted_in,
    record,
    solver_faults,
    unmoved,
    unproven,
)
from vmharness.studies.gather import gather
from vmharness.studies.measured import Measured, Value
from vmharness.studies.variant import Variant

CASES = Path(__file__).parents[2] / "cases"
SOUND = Measured({"x": Value(1.0, 1.0, 0.1, "pass")}, history_sha256="a", cycles=100)


@pytest.fixture
def ball():
    """VM-061 in steps of 0.1 ms, by its parameter."""
    return replace(read(CASES / "VM-061"), overrides={"RHO": 2.5437})


def run(variants):
    done = {n: event for n, event in gather(variants, plant=plant.plant) if isinstance(event, Measured)}
    return [done[n] for n in range(len(variants))]


def studied(case, *names):
    """The findings of the faults of these names."""
    (sound,) = run([Variant(case)])
    chosen = [fault for fault in all_faults(case, sound) if fault.name in names]
    assert len(chosen) == len(names)
    found = record(case, sound, chosen, run([fault.variant for fault in chosen]))
    return found, {one.fault: one for one in found.findings}


def without(case, *keys):
    """The case without these results."""
    kept = [result for result in case.file.results if result.key not in keys]
    return replace(case, file=msgspec.structs.replace(case.file, results=kept))


def test_faults_of_deck_and_solver_are_caught_by_what_they_move(store, ball):
    names = (
        "G +0.1 %",
        "SLSFAC -1 %",
        "M with the opposite sign",
        "contact_stiffness_by_area",
        "half_step_start",
    )
    found, by = studied(ball, *names)
    assert by["G +0.1 %"].noticed is Noticed.CAUGHT
    assert by["G +0.1 %"].share == pytest.approx(1e3, rel=0.02)  # 0.05 % of t_impact against 5e-7
    assert by["SLSFAC -1 %"].by in ("t_peak", "z_peak")
    assert "MASS = &M (-0.5): must be at least 0" in by["M with the opposite sign"].reason
    assert by["contact_stiffness_by_area"].noticed is Noticed.CAUGHT
    assert by["half_step_start"].share > 100.0
    assert by["jaumann_terms_off"].noticed is Noticed.UNSEEN  # no solids: not even run
    assert found.caught == found.applicable == len(names)


def test_a_manual_that_measures_no_stiffness_leaves_the_stiffness_uncaught(store, ball):
    blind = without(ball, "t_peak", "z_peak")
    found, by = studied(blind, "SLSFAC +1 %", "contact_stiffness_by_area", "G +0.1 %")
    assert by["SLSFAC +1 %"].noticed is Noticed.MISSED
    assert by["contact_stiffness_by_area"].noticed is Noticed.MISSED
    assert by["G +0.1 %"].noticed is Noticed.CAUGHT
    missed = [one.fault for one in coverage([found]).missed]
    assert missed == ["contact_stiffness_by_area"]


def test_a_fault_without_effect_is_not_applicable(store, ball):
    _, by = studied(ball, "shell_hourglass_off")  # its wall never moves
    assert by["shell_hourglass_off"].noticed is Noticed.UNSEEN


def test_a_case_that_fails_without_faults_is_not_studied(ball):
    with pytest.raises(StudyError, match="VM-061: the run without a fault does not pass: it diverged"):
        all_faults(ball, Measured(failure="it diverged"))


def one(outcome):
    return finding(CaseFault("f", "F", "physics", Variant(None)), SOUND, outcome)


def test_what_an_outcome_says_of_a_fault():
    wrong = Value(1.0, 2.0, 30.0, "fail", "differs")
    gone = Value(1.0, None, None, "fail", "never happened")
    assert one(replace(SOUND, cached=True, seconds=9.0)).noticed is Noticed.UNSEEN
    moved = one(replace(SOUND, history_sha256="b"))
    assert (moved.noticed, moved.by, moved.share) == (Noticed.MISSED, "x", 0.1)
    caught = one(Measured({"x": wrong}, history_sha256="b"))
    assert (caught.noticed, caught.by, caught.share) == (Noticed.CAUGHT, "x", 30.0)
    never = one(Measured({"x": gone}, history_sha256="b"))
    assert (never.noticed, never.share, never.reason) == (Noticed.CAUGHT, None, "never happened")
    assert one(Measured(failure="refused")).reason == "refused"
    with pytest.raises(StudyError, match="f: defect: PlantError"):
        one(Measured(failure="defect: PlantError: the text is gone"))


def with_value(value, history="b", **others):
    return Measured({"x": Value(1.0, value, 0.1, "pass")}, history_sha256=history, **others)


@pytest.mark.parametrize(
    ("others", "keys"),
    [
        ([with_value(1.0), with_value(1.0 + 1e-14)], ["x"]),  # the runs differ, and the result does not
        ([with_value(1.0), with_value(1.001)], []),
        ([with_value(1.0), with_value(None)], []),  # its event did not happen
        ([with_value(1.0, "a")], []),  # the same run
        ([with_value(1.0, failure="diverged"), with_value(1.0, lost=True)], []),
        ([with_value(1.0), Measured(failure="refused")], ["x"]),
        ([], []),
    ],
)
def test_a_result_that_no_fault_changes_is_named(others, keys):
    assert unmoved(SOUND, others) == keys


def test_the_record_names_it_but_for_faults_of_the_reading():
    case = read(CASES / "VM-061")
    deck, reading = (CaseFault("G +1 %", "G", kind, Variant(case)) for kind in ("deck", "reading"))
    outcomes = [with_value(1.0), with_value(1.001)]
    assert record(case, SOUND, [deck, reading], outcomes).unmoved == ["x"]
    assert record(case, SOUND, [deck, deck], outcomes).unmoved == []


def test_declared_faults_are_planted_in_the_deck_alone(ball):
    declared = {fault.name: fault for fault in deck_faults.declared_faults(ball)}
    assert set(declared) == {fault.text for fault in ball.file.faults}
    stronger = declared["Gravity 0.1 % too strong"].variant.case
    assert stronger.deck_parameters()["G"] == pytest.approx(386.386)
    assert stronger.target("t_impact") == ball.target("t_impact")


def test_a_declared_fault_fails_what_it_must():
    case = read(CASES / "VM-061")
    fault = case.file.faults[0]  # of t_peak and z_peak

    def proven(**others):
        verdicts = {"t_peak": "fail", "z_peak": "pass"}
        results = {key: Value(1.0, 1.1, 2.0, verdict) for key, verdict in verdicts.items()}
        return unproven(case, {fault.text: replace(Measured(results), **others)})

    assert proven() == [f"{fault.text}: z_peak must fail, and passes"]
    assert proven(failure="the run diverged") == []
    assert proven(failure="killed", lost=True) == [f"{fault.text}: could not be judged: killed"]


def test_a_run_that_is_ended_from_outside_is_not_judged():
    killed = one(Measured(failure="the worker process ended: killed by SIGKILL", lost=True))
    assert (killed.noticed, killed.reason) == (
        Noticed.UNJUDGED,
        "the worker process ended: killed by SIGKILL",
    )
    assert one(Measured(failure="defect: MemoryError: ", lost=True)).noticed is Noticed.UNJUDGED
    found = FaultsRecord("VM-061", "", [killed, one(Measured(failure="refused"))])
    assert (found.caught, found.applicable, found.unjudged) == (1, 1, [killed])
    assert not coverage([replace(found, findings=[killed])]).matrix


def test_parameters_are_wrong_one_at_a_time(ball):
    found = {fault.name: fault.variant.case for fault in deck_faults.parameter_faults(ball, 500)}
    assert found["G +5 %"].deck_parameters() == {"RHO": 2.5437, "G": pytest.approx(1.05 * 386.0)}
    assert not any(name.startswith("TEND") for name in found)
    slipped = read_deck(found["H 1000 times as large"])
    assert slipped.one("CONTROL_TERMINATION").endcyc == 500
    assert slipped.one("NODE").z.max() == pytest.approx(1000.0)


def test_a_number_of_the_model_that_nothing_depends_on_is_harmless(ball):
    chosen = [
        fault for fault in deck_faults.parameter_faults(ball, 500) if fault.name.startswith(("RHO", "SLSFAC"))
    ]
    refused = Measured(failure="must be positive")
    moved = [refused if "sign" in fault.name else replace(SOUND, history_sha256="b") for fault in chosen]
    by = {one.fault: one for one in record(ball, SOUND, chosen, moved).findings}
    assert by["RHO 1000 times as large"].noticed is Noticed.HARMLESS
    assert by["RHO +1 %"].noticed is Noticed.HARMLESS
    assert by["SLSFAC +1 %"].noticed is Noticed.MISSED  # it follows from k, which is of the problem


def test_a_length_of_the_mesh_is_a_number_of_the_deck(ball):
    bar = read(CASES / "D-37")
    found = {fault.name: fault.variant.case for fault in deck_faults.parameter_faults(bar, 500)}
    assert not any(name.startswith("n ") for name in found)  # the number of elements numbers the nodes
    (name,) = [name for name in found if name.startswith("L") and name.endswith(" -1 %")]
    x = [read_deck(case).one("NODE").x for case in (bar, found[name])]
    assert np.ptp(x[1]) == pytest.approx(0.99 * np.ptp(x[0]))


def test_a_number_of_which_no_deck_can_be_made_is_no_fault_to_plant():
    names = {fault.name for fault in deck_faults.parameter_faults(read(CASES / "D-51-solid"), 10**6)}
    lengths = {name.removesuffix(" -5 %") for name in names if name.endswith(" -5 %")}
    longer = {name.removesuffix(" 1000 times as large") for name in names if "1000 times" in name}
    assert longer < lengths


def test_a_wrong_unit_of_a_mesh_that_has_no_end_is_no_fault_to_plant(tmp_path):
    solid = read(Path(shutil.copytree(CASES / "D-51-solid", tmp_path / "D-51-solid")))
    most = deck_faults.LARGEST * len(solid.deck_source())
    long = replace(solid, mesh_overrides={"L": 1000.0 * solid.mesh_parameters()["L"]})
    with pytest.raises(
        CaseError, match=r"deck\.k\.j2:\d+: the deck has more than .* characters: its mesh is too fine"
    ):
        long.deck_source(most)
    began = time.monotonic()
    names = {fault.name for fault in deck_faults.parameter_faults(solid, 10**6)}
    assert "L 1000 times as large" not in names
    assert "L +5 %" in names
    assert time.monotonic() - began < 20.0


def test_supports_go_from_the_cards_or_from_the_nodes(ball):
    last, none = deck_faults.support_faults(ball)
    assert not read_deck(last.variant.case).all("BOUNDARY_SPC_SET")
    ring = read(CASES / "D-49")
    codes = [
        read_deck(case).one("NODE")
        for case in (ring, *(f.variant.case for f in deck_faults.support_faults(ring)))
    ]
    held = [int(np.count_nonzero(node.tc | node.rc)) for node in codes]
    assert held == [held[0], held[0] - 1, 0]
    assert none.name == "all supports are missing"


def test_faults_of_the_built_in_solver_are_planted_in_its_own_runs_only(ball):
    own, other = planted_in("builtin"), planted_in("other")
    assert own == plant.faults()
    assert {fault.kind for fault in own} == {"physics", "integration", "reading"}
    assert {fault.kind for fault in other} == {"reading"}  # of history and events, which every solver shares
    assert {fault.name for fault in solver_faults(ball, "other")} <= {fault.name for fault in other}
    found = record(ball, SOUND, [], [], "other")
    assert {one.fault for one in found.findings if one.kind != "deck"} == {fault.name for fault in other}
