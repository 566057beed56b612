"""`vm solve`: any deck."""

import numpy as np
import pytest

from vmharness.explicit.watch import Watch
from vmharness.history import History


def test_energies_are_said(vm, falling):
    code, out, _ = vm("solve", str(falling))
    assert code == 0
    assert "a ball that falls" in out
    rows = {line.split("  ")[0].strip(): line.split()[-1] for line in out.splitlines() if line}
    assert float(rows["kinetic"]) == pytest.approx(
        0.5 * 2.0 * 10.0**2, rel=5e-3
    )  # ends within a step after 1
    assert float(rows["ratio"]) == pytest.approx(1.0, abs=1e-6)


def test_the_file_has_the_nodes_at_the_interval_of_the_deck(vm, falling, tmp_path):
    out = tmp_path / "fall.csv"
    code, _, _ = vm("solve", str(falling), "--csv", str(out))
    assert code == 0
    history = History.from_csv(out)
    np.testing.assert_allclose(history.time, [0.0, 0.25, 0.5, 0.75, 1.0], atol=1.1e-3)
    np.testing.assert_allclose(history["node 2 z-displacement"], -5.0 * history.time**2, atol=1e-6)


def test_a_wrong_deck_is_4_with_its_place(vm, falling):
    falling.write_text(falling.read_text().replace("1,2,2.0", "1,3,2.0"))
    code, _, err = vm("solve", str(falling))
    assert code == 4
    assert "fall.k:" in err
    assert "*ELEMENT_MASS" in err
    assert "Traceback" not in err


def test_a_run_that_fails_is_6_after_what_it_has(vm, falling):
    text = falling.read_text().replace("0.0,0.9,,,,1", "0.0,5.0").replace("1,1e-6", "1,1e6")
    falling.write_text(text.replace("*LOAD_BODY_Z", "*INITIAL_VELOCITY_NODE\n2,1.0\n*LOAD_BODY_Z"))
    code, out, err = vm("solve", str(falling))
    assert code == 6
    assert "diverged" in err
    assert "kinetic" in out


def test_a_run_with_an_energy_that_cannot_be_is_6_after_its_energies(vm, falling, monkeypatch):
    monkeypatch.setattr(Watch, "impossible", lambda watch: "the run cannot be judged: made for this test")
    code, out, err = vm("solve", str(falling))
    assert code == 6
    assert "made for this test" in err
    assert "kinetic" in out


@pytest.mark.parametrize(
    "asked", ["_ID\n         2the ball\n", "_SET\n7\n*SET_NODE_LIST_GENERATE\n7\n2,5\n", "\n2\n"]
)
def test_nodes_are_asked_for_by_number_name_or_set(vm, falling, tmp_path, asked):
    falling.write_text(falling.read_text().replace("_HISTORY_NODE\n2\n", f"_HISTORY_NODE{asked}"))
    code, _, err = vm("solve", str(falling), "--csv", str(tmp_path / "fall.csv"))
    assert (code, err) == (0, "")
    history = History.from_csv(tmp_path / "fall.csv")
    np.testing.assert_allclose(history["node 2 z-displacement"], -5.0 * history.time**2, atol=1e-6)
    assert not any(name.startswith("node 1 ") for name in history.channels)


def test_a_set_of_nodes_that_is_not_there_is_named(vm, falling):
    falling.write_text(falling.read_text().replace("_HISTORY_NODE\n2\n", "_HISTORY_NODE_SET\n7\n"))
    code, _, err = vm("solve", str(falling))
    assert code == 4
    assert "*DATABASE_HISTORY_NODE_SET: IDS = 7: no *SET_NODE_... with SID = 7; defined: none" in err


def test_an_interval_below_the_step_gives_every_cycle(vm, falling, tmp_path):
    falling.write_text(falling.read_text().replace("*DATABASE_NODOUT\n0.25", "*DATABASE_NODOUT\n1e-12"))
    code, _, _ = vm("solve", str(falling), "--csv", str(tmp_path / "fall.csv"))
    assert code == 0
    time = History.from_csv(tmp_path / "fall.csv").time
    np.testing.assert_allclose(time, 0.001 * np.arange(1001), rtol=1e-9)


@pytest.mark.parametrize("name", ["none/fall.csv", "fall.k/fall.csv"])
def test_a_file_that_cannot_be_written_is_said_before_the_run(vm, falling, name):
    code, out, err = vm("solve", str(falling), "--csv", str(falling.parent / name))
    assert code == 4
    assert "there is no folder" in " ".join(err.split())
    assert "cycles" not in out


def test_the_file_can_be_standard_output(vm, falling):
    code, out, err = vm("solve", str(falling), "--csv", "-")
    assert code == 0
    assert out.startswith("time,kinetic,")
    assert "cycles to t" in err


def test_what_has_no_effect_is_said_once(vm, falling):
    text = falling.read_text()
    sets = "".join(f"*SET_NODE_LIST\n{sid},1.0\n2\n" for sid in (11, 12))
    falling.write_text(text + sets + "*CONTROL_SOLUTION\n0,0,0,500\n")
    code, out, _ = vm("solve", str(falling))
    assert code == 0
    lines = [line.strip() for line in out.splitlines() if "DA1" in line or "LCINT" in line]
    assert lines == [
        "*SET_NODE_LIST: DA1 = 1.0: nothing here uses attributes of sets (2 such cards)",
        "*CONTROL_SOLUTION: LCINT = 500: curves are used as they are",
    ]
