"""MuJoCo runs the decks of the manual that it can represent, and is judged by the same theory."""

import os
from importlib import util
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from vmharness.backends import backend, mujoco
from vmharness.backends.mujoco import translate
from vmharness.backends.mujoco.mjcf import document
from vmharness.backends.protocol import Job
from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.case.format import Channel
from vmharness.compare import Verdict
from vmharness.deck import DeckError, vocabulary
from vmharness.deck import read as read_keywords
from vmharness.run import run

CASES = Path(__file__).parents[2] / "cases"
INSTALLED = util.find_spec("mujoco") is not None
REQUIRED = "VMHARNESS_SOLVERS" in os.environ  # where every solver must be there, a missing one is a failure

installed = pytest.mark.skipif(not (INSTALLED or REQUIRED), reason=mujoco.INSTALL)

HEAD = """*KEYWORD
*CONTROL_TERMINATION
0.5
*NODE
1,0.,0.,0.,7,7
2,2.,0.,0.
"""
MASS = "*ELEMENT_MASS\n2,2,4.0\n"
SPRING = """*PART
spring
1,1,1
*SECTION_DISCRETE
1,0

*ELEMENT_DISCRETE
1,1,1,2
"""
CURVE = "*DEFINE_CURVE\n1\n0.,0.\n10.,10.\n"


def deck_of(text, tmp_path):
    path = tmp_path / "deck.k"
    path.write_text(HEAD + text + "*END\n")
    return read_keywords(path, vocabulary())


def solve(text, tmp_path, **channels):
    folder = tmp_path / "work"
    folder.mkdir()
    given = {name: Channel(text=name, **values) for name, values in channels.items()}
    return backend("mujoco").solve(Job(deck_of(text, tmp_path), given, folder))


@installed
@pytest.mark.parametrize(
    "id", ["VM-071", "VM-072", "VM-075", "VM-182", "VM-061", "D-01", "D-15", "D-31", "D-32", "D-34", "D-23"]
)
def test_it_agrees_with_theory_as_closely_as_the_built_in_solver_must(id, tmp_path):
    found = run(read(CASES / id), backend("mujoco"), folder=tmp_path)
    assert found.verdict is Verdict.PASS, found.reason
    assert {row.verdict for row in found.rows} <= {Verdict.PASS, Verdict.UNREPORTED}
    assert "RK4" in found.solution.facts["Integrator"]
    assert (tmp_path / "model.xml").exists()


@installed
def test_a_stiff_cord_at_a_quarter_of_its_critical_step_is_beyond_the_budget_of_central_differences(tmp_path):
    found = run(read(CASES / "VM-091"), backend("mujoco"), folder=tmp_path)
    assert [row.key for row in found.rows if row.verdict is not Verdict.PASS] == ["S_1"]
    force = next(row for row in found.rows if row.key == "S_1").comparison
    assert abs(force.value / force.target - 1.0) < 1e-3


@installed
@pytest.mark.parametrize("name", ["m", "g"])
def test_a_wrong_datum_in_the_deck_fails(name, tmp_path):
    case = read(CASES / "VM-061")
    wrong = case.with_deck_of({name: 1.01 * case.datum(name)})
    assert run(wrong, backend("mujoco"), folder=tmp_path).verdict is Verdict.FAIL


@installed
def test_what_it_does_not_report_is_counted_as_that(tmp_path):
    found = run(read(CASES / "D-23"), backend("mujoco"), folder=tmp_path)
    assert [row.key for row in found.unreported] == ["w_A", "w_B"]
    assert "does not report 'friction energy'" in found.unreported[0].comparison.reason


@installed
def test_a_base_acceleration_that_varies_acts_within_the_step(tmp_path):
    """a = -t along x gives u = -t^3/6, which the Runge-Kutta method has without error."""
    output = solve(
        MASS + CURVE + "*LOAD_BODY_X\n1,1.0\n", tmp_path, u=dict(node=2, component="x-displacement")
    )
    assert output.failure == ""
    t = output.history.time
    np.testing.assert_allclose(output.history["u"], -(t**3) / 6.0, rtol=1e-9, atol=1e-14)


@installed
def test_energies_of_a_mass_that_falls_on_a_spring_add_up_to_the_work_of_gravity(tmp_path):
    """m v^2/2 + k u^2/2 = -m g u, with the spring along x and gravity of 3 along x."""
    text = (
        MASS
        + SPRING
        + "*MAT_SPRING_ELASTIC\n1,50.\n"
        + CURVE.replace("0.,0.", "0.,10.")
        + "*LOAD_BODY_X\n1,0.3\n*CONTROL_TIMESTEP\n0.,0.01\n"
    )
    kinetic, internal = ({"energy": name} for name in ("kinetic", "internal"))
    place = {"node": 2, "component": "x-displacement"}
    output = solve(text, tmp_path, kinetic=kinetic, internal=internal, u=place)
    u = output.history["u"]
    assert u.min() < -0.2
    np.testing.assert_allclose(output.history["internal"], 25.0 * u**2, atol=1e-12)
    np.testing.assert_allclose(output.history["kinetic"] + output.history["internal"], -12.0 * u, atol=1e-7)


@installed
def test_a_warning_of_mujoco_ends_the_run_and_cannot_be_judged(tmp_path):
    huge = "*INITIAL_VELOCITY_NODE\n2,1.0e200\n"
    output = solve(MASS + huge, tmp_path, u=dict(node=2, component="x-displacement"))
    assert "MuJoCo warned of" in output.failure


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (MASS + SPRING + "*MAT_SPRING_ELASTOPLASTIC\n1,1.,1.,1.\n", "MAT_SPRING_ELASTOPLASTIC: the keyword is not"),
        (MASS + SPRING.replace("1,1,1,2\n", "1,1,1,2,0,1.0,0,3.0\n") + "*MAT_SPRING_ELASTIC\n1,5.\n", "rest length would be neg"),
        (SPRING + "*MAT_SPRING_ELASTIC\n1,5.\n", "node 2 can move and has no mass"),
    ],
)  # fmt: skip
def test_what_it_cannot_represent_is_refused_by_name(text, message, tmp_path):
    with pytest.raises(DeckError, match=message):
        translate.model_of(deck_of(text, tmp_path))


@pytest.mark.parametrize(
    ("id", "message"),
    [
        (
            "D-20",
            "N1 = 1: mujoco: the node is not held in x, y and z; shells that deform are not represented",
        ),
        ("D-22", "RIGIDWALL_PLANAR_ID: the keyword is not supported"),
    ],
)
def test_a_problem_that_it_cannot_pose_is_neither_a_pass_nor_a_failure(id, message, tmp_path):
    found = run(read(CASES / id), backend("mujoco"), folder=tmp_path)
    if not found.solution.unrepresentable:
        pytest.skip(found.reason)  # it is not installed
    assert {row.verdict for row in found.rows} == {Verdict.UNREPRESENTABLE} == {found.verdict}
    assert message in found.reason


def test_the_stiffness_of_a_contact_is_that_of_the_penalty_formula():
    case = read(CASES / "VM-061")
    contact = translate.model_of(read_deck(case)).contacts[0]
    assert contact.stiffness == pytest.approx(case.datum("k"), rel=2e-5)  # SLSFAC has five digits
    assert contact.spring


def test_the_model_is_a_file_of_mujoco_with_the_velocities_of_the_deck():
    model = translate.model_of(read_deck(read(CASES / "D-34")))
    root = ElementTree.fromstring(document(model, 1e-4))
    assert [joint.get("type") for joint in root.iter("joint")] == ["ball"]
    assert root.find("keyframe/key").get("qvel") == "300.0 0.0 0.654"


def test_it_says_how_to_install_what_is_missing(monkeypatch):
    monkeypatch.setattr(util, "find_spec", lambda name: None)
    assert "pip install 'vmharness[mujoco]'" in mujoco.found().missing
