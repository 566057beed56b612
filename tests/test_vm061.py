"""VM-061 through the built-in solver: within theory, balanced, and unable to pass when something is wrong."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from vmharness import measure
from vmharness.backends import builtin
from vmharness.backends.builtin import cycles
from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.explicit.kernels import integrate
from vmharness.explicit.probes import motion
from vmharness.history import History
from vmharness.run import run

CASE = read(Path(__file__).parents[1] / "cases" / "VM-061")
COARSE = replace(
    CASE, overrides={"RHO": 2.5437}
)  # dt = 1e-4 s; nothing else, since the wall's nodes are fixed


@pytest.fixture(scope="module")
def clean():
    """The case as it lies in its folder."""
    return run(CASE, builtin)


def test_every_result_is_within_a_thousandth_of_a_percent(clean):
    assert clean.verdict is Verdict.PASS
    errors = {row.key: row.comparison.error_percent for row in clean.rows}
    assert set(errors) == {"t_impact", "z_impact", "v_impact", "ke_impact", "t_peak", "z_peak"}
    assert max(map(abs, errors.values())) < 1e-3


def test_the_published_rounding_of_slsfac_is_what_moves_the_peak(clean):
    # k = SLSFAC K A/d = 1973.8886: theory with that k is met far closer.
    k = 2.7915e-4 / CASE.theory["slsfac"] * CASE.given["k"]
    assert k == pytest.approx(1973.8886, abs=1e-4)
    theory = CASE.with_given({"k": k})
    for row in clean.rows:
        if row.event == "At Maximum Displacement":
            assert row.comparison.value == pytest.approx(theory.target(row.key), rel=2e-9)
    assert 100 * (theory.target("z_peak") / CASE.target("z_peak") - 1) == pytest.approx(0.00034, abs=1e-5)


def test_no_error_exceeds_its_budget(clean):
    for row in clean.rows:
        assert abs(row.comparison.error_percent) <= 100 * row.budget
        assert row.comparison.tolerance_percent <= 0.01


def test_energy_ratio_stays_one(clean):
    ratio = clean.solution.history["ratio"]
    assert ratio[0] == 1.0
    assert np.abs(ratio - 1.0).max() < 1e-7


def test_reactions_balance_contact_and_body_force(clean):
    # The wall weighs rho L^2 t g; its supports carry that and the contact force, to round-off.
    history = clean.solution.history
    weight = 7.3e-4 * 0.4**2 * 0.1 * CASE.given["g"]
    error = history["reaction"] - history["contact_force"] - weight
    assert np.abs(error).max() < 1e-13 * history["contact_force"].max()


def test_history_follows_the_curves_of_the_theory(clean):
    history = clean.solution.history
    for name in CASE.file.curves:
        scale = np.abs(history[name]).max()
        assert np.abs(history[name] - CASE.curve(name, history.time)).max() < 3e-5 * scale


def test_step_and_cycles_are_those_of_the_shell(clean):
    # 0.9 L/c with L = A/longest side and c = sqrt(E/(rho (1 - nu^2)))
    dt = 0.9 * 0.4 / np.sqrt(3e7 / (7.3e-4 * (1 - 0.3**2)))
    np.testing.assert_allclose(np.diff(clean.solution.history.time), dt, rtol=1e-9)
    assert clean.solution.cycles == int(np.ceil(0.11 / dt))


def test_read_as_the_published_column_was_read_it_gives_that_column(clean):
    readings = {reading.key: reading for reading in clean.readings["LS-DYNA"]}
    assert {key for key, reading in readings.items() if not reading.same} == {"ke_impact"}
    kinetic = readings["ke_impact"]
    assert f"{kinetic.read:.2f}" == "193.09"
    assert kinetic.other == (0.072, pytest.approx(193.0986, abs=1e-4))
    assert kinetic.other_same


@pytest.mark.parametrize("seed", range(20))
def test_other_data_agree_as_well(seed):
    m, k, h, g = np.exp(np.random.default_rng(seed).uniform(np.log(0.5), np.log(2.0), 4)) * [
        0.5,
        1973.92,
        1,
        386,
    ]
    other = run(CASE.with_given({"m": m, "k": k, "h": h, "g": g}), builtin)
    assert max(abs(row.comparison.error_percent) for row in other.rows) < 0.002


@pytest.mark.parametrize(
    "data", [{"h": 0.05}, {"h": 0.001}, {"g": 20000.0}, {"m": 50.0}, {"k": 1e6}], ids=str
)
def test_one_datum_far_off_agrees_as_well(data):
    other = run(CASE.with_given(data), builtin)
    assert max(abs(row.comparison.error_percent) for row in other.rows) < 0.002
    assert other.verdict is Verdict.PASS


def test_a_step_sixty_times_longer_is_still_right():
    coarse = run(COARSE, builtin)
    assert coarse.solution.history.time[1] == pytest.approx(1e-4, rel=1e-4)
    assert max(abs(row.comparison.error_percent) for row in coarse.rows) < 1e-3
    assert coarse.verdict is Verdict.PASS


def full_step_start(monkeypatch):
    """v_{1/2} = v_0 + dt a_0: the first step takes a whole step's acceleration."""
    right = integrate.advance_velocity
    calls = []

    def wrong(v, omega, a, alpha, dt):
        calls.append(dt)
        right(v, omega, a, alpha, 2.0 * dt if len(calls) == 1 else dt)

    monkeypatch.setattr(integrate, "advance_velocity", wrong)


def half_step_velocity(monkeypatch):
    """v_{n-1/2} is reported as v_n."""
    right = motion.of_node

    def wrong(model, node, component):
        s, row = model.state, int(np.flatnonzero(model.ids == node)[0])
        return (lambda: s.v[row, 2]) if component == "z-velocity" else right(model, node, component)

    monkeypatch.setitem(motion.PROBES, "node", wrong)


def late_stamp(monkeypatch):
    """Every sample carries the time of the next one."""
    right = cycles.record

    def wrong(model, probes, *options):
        history, failure, seconds = right(model, probes, *options)
        return History(history.time + history.time[1], history.channels), failure, seconds

    monkeypatch.setattr(cycles, "record", wrong)


def first_sample(monkeypatch):
    """Onset is the first sample with force."""
    monkeypatch.setattr(measure, "onsets", lambda t, y: [t[np.flatnonzero(y)[0]]])


@pytest.mark.parametrize(
    ("fault", "key", "percent"),
    [
        (full_step_start, "t_impact", -0.07),
        (half_step_velocity, "v_impact", -0.07),
        (late_stamp, "t_impact", 0.14),
        (first_sample, "t_impact", 0.026),
    ],
)
def test_faults_of_integration_and_reading_are_caught(monkeypatch, fault, key, percent):
    fault(monkeypatch)
    wrong = run(COARSE, builtin)
    row = next(row for row in wrong.rows if row.key == key)
    assert row.verdict is Verdict.FAIL
    assert row.comparison.error_percent == pytest.approx(percent, rel=0.1)


def test_an_event_that_does_not_happen_fails_its_results():
    early = run(replace(CASE, overrides={"TEND": 0.08, "RHO": 2.5437}), builtin)
    assert early.verdict is Verdict.FAIL
    for row in early.rows:
        expected = Verdict.FAIL if row.event == "At Maximum Displacement" else Verdict.PASS
        assert row.verdict is expected
    assert "At Maximum Displacement: did not happen within the run" in early.reason


def test_a_second_impact_is_more_than_declared():
    twice = run(replace(CASE, overrides={"TEND": 0.32, "RHO": 2.5437}), builtin)
    assert "happened 2 times, at 0.07198" in twice.reason
    assert all(row.verdict is Verdict.FAIL for row in twice.rows)


def test_a_solver_that_breaks_down_cannot_be_judged_and_keeps_what_it_has(monkeypatch):
    right = integrate.accelerate
    calls = []

    def breaks(a, *arrays):
        calls.append(0)
        return float("nan") if len(calls) > 900 else right(a, *arrays)

    monkeypatch.setattr(integrate, "accelerate", breaks)
    broken = run(COARSE, builtin)
    assert broken.verdict is Verdict.ERROR
    assert "cycle 900: the motion is no longer finite" in broken.reason
    assert len(broken.solution.history) == 900
    impact = [row for row in broken.rows if row.event == "At Impact"]
    assert all(row.verdict is Verdict.PASS for row in impact)  # what happened before is still measured


def test_a_deck_that_cannot_be_read_is_said_and_not_judged():
    wrong = run(replace(CASE, overrides={"RHO": -1.0}), builtin)
    assert wrong.verdict is Verdict.ERROR
    assert "deck.k" in wrong.reason
    assert "*MAT_ELASTIC: RO = &RHO (-1.0): must be greater than 0" in wrong.reason
    assert all(row.verdict is Verdict.ERROR for row in wrong.rows)
