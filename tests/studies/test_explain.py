"""Where a difference comes from, found where it is known: a lag of the reading, a rounded number, a coarse step."""

from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
import pytest

from vmharness.case import CaseError, read
from vmharness.studies.explain.record import SAMPLING, Part, explained, halved
from vmharness.studies.explain.runs import (
    NUMBERS,
    PENALTY,
    SOUND,
    STIFF,
    TIME_STEP,
    record,
    variants,
)
from vmharness.studies.faults import plant
from vmharness.studies.gather import gather
from vmharness.studies.measured import Measured

CASES = Path(__file__).parents[2] / "cases"


@pytest.fixture
def coarse():
    """VM-061 in steps of 0.1 ms, by its parameter."""
    case = read(CASES / "VM-061")
    return replace(case, overrides={"RHO": 2.5437})


def explain(case, fault=""):
    runs = {name: replace(variant, fault=fault) for name, variant in variants(case).items()}
    done = {
        n: event for n, event in gather(list(runs.values()), plant=plant.plant) if isinstance(event, Measured)
    }
    outcomes = {name: done[n] for n, name in enumerate(runs)}
    return {one.key: one for one in record(case, outcomes).results}


def parts(one):
    return {part.cause: part for part in one.parts}


def test_a_lag_of_the_reading_is_sampling(store, coarse):
    digest = plant.fault("onset_at_first_sample").digest
    one = explain(coarse, digest)["t_impact"]
    step = 1e-4
    assert 0.01 * step < one.difference < step
    assert one.difference > 10 * one.allowed
    found = parts(one)
    assert abs(found[TIME_STEP].value) < 0.01 * one.difference
    assert found[SAMPLING].value > 0.5 * one.difference
    assert abs(found[SAMPLING].value - one.difference) <= found[SAMPLING].open
    assert abs(one.unexplained.value) <= one.unexplained.open


def test_the_rounding_of_the_deck_and_the_time_step_are_told_apart(store, coarse):
    one = explain(coarse)["z_peak"]
    found = parts(one)
    # Theory with the k of the rounded SLSFAC says what the first is; s_dt bounds the second.
    k = 2.7915e-4 / coarse.theory["slsfac"] * coarse.given["k"]
    rounded = coarse.with_given({"k": k}).target("z_peak") - coarse.target("z_peak")
    assert found[NUMBERS].value == pytest.approx(rounded, rel=0.01)
    assert 0.0 < abs(found[TIME_STEP].value) <= coarse.theory["s_dt"] * abs(one.target)
    assert abs(one.unexplained.value) < 0.02 * abs(one.difference)


def test_a_penalty_that_is_no_datum_is_told_by_twice_the_stiffness(store, coarse):
    parameters = {name: text for name, text in coarse.file.deck.parameters.items() if name != "SLSFAC"}
    deck = msgspec.structs.replace(coarse.file.deck, parameters=parameters)
    case = replace(coarse, file=msgspec.structs.replace(coarse.file, deck=deck))
    found = parts(explain(case)["z_peak"])
    twice = coarse.with_given({"k": 2.0 * coarse.given["k"]}).target("z_peak")
    assert found[PENALTY].value == pytest.approx(2.0 * (coarse.target("z_peak") - twice), rel=1e-2)
    assert found[PENALTY].open == pytest.approx(abs(found[PENALTY].value) / 2.0, rel=0.01)
    assert PENALTY not in parts(explain(coarse)["z_peak"])


def test_a_failed_run_is_not_explained(coarse):
    with pytest.raises(CaseError, match="the run of the unchanged case failed: it diverged"):
        record(coarse, {SOUND: Measured(failure="it diverged")})


def test_a_sequence_that_converges_is_carried_to_zero():
    def value(h):
        return 5.0 + 3.0 * h**2

    part = halved(value(1.0) - value(0.5), value(0.5) - value(0.25), "step")
    assert part == Part("step", pytest.approx(3.0), 0.0)
    first = halved(2.0, 1.0, "step")
    assert first.value == pytest.approx(4.0)
    assert halved(1.0, 2.0, "step").open == 2.0  # grows: the last difference is left open


def test_parts_add_up_to_the_difference():
    one = explained("x", "X", "m", 1.0, 1.25, 0.1, [Part("a", 0.2, 0.01), Part("b", -0.05)])
    assert one.unexplained == Part("unexplained", pytest.approx(0.1), 0.01, "difference")
    assert one.difference == pytest.approx(0.25)
    assert np.isclose(sum(part.value for part in one.parts), one.difference)


@pytest.mark.parametrize(
    ("id", "penalty"),
    [
        ("D-18", False),
        ("D-20", False),
        ("VM-061", False),
        ("D-28-shell", False),
        ("D-40", True),
    ],
)
def test_a_stiffness_that_the_problem_gives_is_no_penalty(id, penalty):
    """D-18 has it in the deck by an expression of K; the bars of D-40 meet by a penalty that no theory knows."""
    assert (STIFF in variants(read(CASES / id))) == penalty
