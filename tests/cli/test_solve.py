"""`vm solve`: any deck."""

import numpy as np
import pytest

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
