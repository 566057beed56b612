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
    "id", ["VM-071", "VM-075", "VM-182", "VM-061", "D-01", "D-15", "D-31", "D-32", "D-34", "D-23"]
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
@pytest.mark.parametrize("name", ["rho", "g"])
def test_a_wrong_datum_in_the_deck_fails(name, tmp_path):
    case = read(CASES / "D-31")
    wrong = case.with_deck_of({name: 1.01 * case.datum(name)})
    assert run(wrong, backend("mujoco"), folder=tmp_path).verdict is Verdict.FAIL


@installed
def test_what_it_does_not_report_is_counted_as_that(tmp_path):
    found = run(read(CASES / "D-01"), backend("mujoco"), folder=tmp_path)
    assert [row.key for row in found.unreported] == ["ratio_land"]
    assert "does not report 'ratio'" in found.unreported[0].comparison.reason


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


BODY = """*PART_INERTIA
body {pid}
{pid},1,1
{x},0.,0.,{m}
0.1,0.,0.,{i},0.,{i}
0.,0.,0.,0.,0.,0.
*CONSTRAINED_EXTRA_NODES_NODE
{extra}
"""
CHAIN = (
    """*SECTION_SOLID
1,1
*MAT_RIGID
1,1.,1.,0.3
0


*MAT_RIGID
2,1.,1.,0.3
1,7,7

*NODE
11,0.,0.,0.
12,0.,0.,0.
21,0.,1.,0.
22,0.,1.,0.
31,2.,0.,0.
32,2.,0.,0.
*CONTROL_TIMESTEP
0.,0.9,0,0.,0.,1
"""
    + "*DEFINE_CURVE\n1\n0.,0.001\n10.,0.001\n*DEFINE_CURVE\n2\n0.,1.\n10.,1.\n*LOAD_BODY_Z\n2,10.\n"
    + BODY.format(pid=1, x=0.0, m=1.0, i=0.1, extra="1,11\n1,21").replace("1,1,1\n", "1,1,2\n", 1)
    + BODY.format(pid=2, x=1.0, m=2.0, i=0.3, extra="2,12\n2,22\n2,31")
    + BODY.format(pid=3, x=3.0, m=1.5, i=0.2, extra="3,32")
    + "*CONSTRAINED_JOINT_REVOLUTE\n11,12,21,22\n*CONSTRAINED_JOINT_SPHERICAL\n32,31\n"
)


@installed
def test_a_chain_of_bodies_keeps_energy_and_its_joints_carry_the_change_of_momentum(tmp_path):
    names = {f"v{b}": dict(rigid=b, component="z-velocity") for b in (2, 3)}
    names |= {f"z{b}": dict(rigid=b, component="z-coordinate") for b in (2, 3)}
    names |= {f"F{j}": dict(joint=j, component="z-force") for j in (1, 2)}
    output = solve(CHAIN, tmp_path, kinetic=dict(energy="kinetic"), **names)
    assert output.failure == ""
    h = output.history
    work = -10.0 * (2.0 * h["z2"] + 1.5 * h["z3"])
    assert work.max() > 10.0
    np.testing.assert_allclose(h["kinetic"], work, atol=1e-8)
    change = np.gradient(1.5 * h["v3"], h.time)[2:-2]
    np.testing.assert_allclose(h["F2"][2:-2], change + 15.0, atol=1e-3)  # on body 3, of the first node
    change = np.gradient(2.0 * h["v2"] + 1.5 * h["v3"], h.time)[2:-2]
    np.testing.assert_allclose(h["F1"][2:-2], -(change + 35.0), atol=1e-3)  # on the ground, of the first node


def test_joints_that_close_a_loop_are_refused(tmp_path):
    loop = "*CONSTRAINED_JOINT_SPHERICAL\n21,22\n"
    with pytest.raises(DeckError, match="JOINT_SPHERICAL: mujoco: the joint closes a loop of bodies"):
        translate.model_of(deck_of(CHAIN + loop, tmp_path))


@installed
def test_a_flat_body_in_any_axes_is_one_that_mujoco_takes(tmp_path):
    """Principal moments 1, 2 and 3, which MuJoCo refuses if round-off makes the last greater than the sum."""
    q = np.linalg.qr([[1.0, 2.0, 0.3], [0.2, 1.0, 0.7], [0.9, 0.1, 1.0]])[0]
    i = q @ np.diag([1.0, 2.0, 3.0]) @ q.T
    card = ",".join(repr(float(i[k])) for k in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)))
    text = BODY.format(pid=1, x=0.0, m=1.0, i=0.1, extra="1,2").replace("0.1,0.,0.,0.1,0.,0.1", card)
    text = "*SECTION_SOLID\n1,1\n*MAT_RIGID\n1,1.,1.,0.3\n0\n\n" + text.replace(
        "0.,0.,0.,0.,0.,0.", "0.,0.,0.,1.,2.,3."
    )
    output = solve(
        text, tmp_path, **{axis: dict(rigid=1, component=f"{axis}-angular-momentum") for axis in "xyz"}
    )
    for k, axis in enumerate("xyz"):
        np.testing.assert_allclose(output.history[axis], (i @ [1.0, 2.0, 3.0])[k], rtol=1e-7)


FLOOR = """*NODE
3,1.,-1.,-1.,7,7
4,3.,-1.,-1.,7,7
5,3.,1.,-1.,7,7
6,1.,1.,-1.,7,7
*PART
floor
1,1,1
*SECTION_SHELL
1,2
0.01,0.01,0.01,0.01
*MAT_ELASTIC
1,1000.,1.0e7,0.3
*ELEMENT_SHELL
1,1,3,4,5,6
*SET_NODE_LIST
1
2
"""
CONTACT = "*CONTACT_NODES_TO_SURFACE\n1,1,4,3\n{},{},0.,0.,{}\n\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (FLOOR + CONTACT.format(0.3, 0.2, 0.0), "one coefficient of friction only: FD must be FS"),
        (FLOOR.replace("6,1.,1.,-1.", "6,1.,1.,-1.5") + CONTACT.format(0.0, 0.0, 0.0), "the surface is not flat"),
        (FLOOR.replace("3.,", "1.5,") + CONTACT.format(0.0, 0.0, 0.0), "node 2 does not begin over the surface"),
        (FLOOR.replace("5,3.,1.,-1.,7,7", "5,3.,1.,-1.,6,7") + CONTACT.format(0.0, 0.0, 0.0), "N3 = 5: mujoco: the node is not held"),
    ],
)  # fmt: skip
def test_contacts_that_it_cannot_represent_are_refused_by_name(text, message, tmp_path):
    with pytest.raises(DeckError, match=message):
        translate.model_of(deck_of(MASS + text, tmp_path))


@installed
def test_a_damped_contact_gives_back_what_its_damping_leaves(tmp_path):
    """From the beginning to zero force: v/v0 = exp(-z a/sqrt(1 - z^2)), a the phase angle, for the damping z."""
    fall = "*INITIAL_VELOCITY_NODE\n2,0.,0.,-10.\n*CONTROL_TIMESTEP\n0.,0.02\n"
    output = solve(
        MASS + FLOOR + CONTACT.format(0.0, 0.0, 30.0) + fall, tmp_path, v=dict(node=2, component="z-velocity")
    )
    z = 0.3
    ratio = np.exp(-z / np.sqrt(1.0 - z**2) * np.arctan2(2.0 * z * np.sqrt(1.0 - z**2), 2.0 * z**2 - 1.0))
    assert output.history["v"][-1] == pytest.approx(
        10.0 * ratio, rel=5e-3
    )  # first order in the step: the damping force begins with a jump
