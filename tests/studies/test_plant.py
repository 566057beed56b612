"""Planting: the text is found just once, the fault acts in a new process, and a sound one afterwards is unchanged."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from vmharness.studies.faults import plant

ROOT = Path(__file__).parents[2]
FAULTS = plant.faults()

# The modulus of a plate under de_xx = 1 at nu = 0.5, from a kernel as a shell calls it.
PLATE = """
import sys
from vmharness.studies.faults.plant import fault, plant
for name in sys.argv[1:]:
    plant(fault(name).digest)
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.materials.elastic import Elastic, plane_stress
import numpy as np

@kernel
def stress(history):
    return plane_stress(Elastic(3.0, 0.5), 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, history, 0, 1)[0]

print(stress(np.zeros(1)))
"""


def plate(tmp_path, *faults):
    """The stress, from a file that a process of its own runs, so that its kernel is kept on disk."""
    script = tmp_path / "plate.py"
    script.write_text(PLATE)
    env = {**os.environ, "PYTHONPATH": str(ROOT), "VMHARNESS_CACHE": str(tmp_path / "cache")}
    done = subprocess.run(
        [sys.executable, str(script), *faults], env=env, capture_output=True, text=True, check=True
    )
    return float(done.stdout)


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.name)
def test_the_sound_text_stands_in_its_module_just_once_and_the_faulty_one_compiles(fault):
    source = plant.source_of(fault.module)
    faulty = fault.planted(source)
    assert faulty != source
    compile(faulty, fault.module, "exec")


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault.name)
def test_a_fault_says_what_it_is(fault):
    assert fault.kind in ("physics", "integration", "reading")
    assert fault.text
    assert not fault.text.endswith(".")


def test_each_fault_has_a_name_and_a_digest_of_its_own():
    assert len({fault.name for fault in FAULTS}) == len(FAULTS) == 46
    assert len({fault.digest for fault in FAULTS}) == len(FAULTS)
    fault = FAULTS[0]
    assert replace(fault, faulty=fault.faulty + " ").digest != fault.digest


def test_a_text_that_is_gone_or_there_twice_is_said():
    fault = replace(FAULTS[0], sound="a = b")
    with pytest.raises(plant.PlantError, match=r"'a = b' stands nowhere in .*: bring the fault up to date"):
        fault.planted("c = d\n")
    with pytest.raises(plant.PlantError, match="stands 2 times"):
        fault.planted("a = b\na = b\n")


def test_an_unknown_fault_is_said():
    with pytest.raises(plant.PlantError, match=r"no fault gravity_off; there are: .*body_load_sign"):
        plant.fault("gravity_off")


def test_a_module_that_is_imported_cannot_be_planted():
    late = next(fault for fault in FAULTS if fault.module == "vmharness.events")
    import vmharness.events  # noqa: F401

    before = list(sys.meta_path)
    with pytest.raises(plant.PlantError, match=r"vmharness\.events is imported already"):
        plant.plant(late.digest)
    assert sys.meta_path == before


def test_a_fault_that_has_changed_is_not_planted():
    with pytest.raises(plant.PlantError, match="jaumann_terms_off: its texts have changed"):
        plant.plant("jaumann_terms_off-0123456789abcdef")


def test_a_sound_run_after_a_planted_one_is_unchanged(tmp_path):
    sound, name = plate(tmp_path), "plate_modulus_without_poisson"
    assert sound == pytest.approx(4.0, rel=1e-12)  # E / (1 - nu^2)
    assert plate(tmp_path, name) == pytest.approx(3.0, rel=1e-12)
    assert plate(tmp_path, name) == pytest.approx(3.0, rel=1e-12)  # from the cache
    assert plate(tmp_path) == sound
    kernels = [path.name.split("-")[0] for path in (tmp_path / "cache").glob("kernels-*/*")]
    assert sorted(kernels) == ["plane_stress", "plane_stress", "stress", "stress"]
