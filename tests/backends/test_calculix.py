"""CalculiX runs the decks of the manual that it can represent; what it prints is read strictly."""

import os
import shutil
from pathlib import Path

import numpy as np
import pytest

from vmharness import deck
from vmharness.backends import backend, calculix
from vmharness.backends._translation.review import planned
from vmharness.backends.calculix import masses
from vmharness.backends.calculix.channels import plan
from vmharness.backends.calculix.clock import amplitude, clock
from vmharness.backends.calculix.dat import DatError
from vmharness.backends.calculix.dat import read as read_dat
from vmharness.backends.calculix.model import real
from vmharness.backends.calculix.plan import NotReportedError
from vmharness.backends.calculix.translate import model_of, steps, written
from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.case.format import Channel
from vmharness.compare import Verdict
from vmharness.deck import DeckError
from vmharness.run import run

CASES = Path(__file__).parents[2] / "cases"
INSTALLED = shutil.which(calculix.PROGRAM) is not None
REQUIRED = "VMHARNESS_SOLVERS" in os.environ  # where every solver must be there, a missing one is a failure

installed = pytest.mark.skipif(not (INSTALLED or REQUIRED), reason=calculix.INSTALL)
programs = pytest.mark.skipif(os.name != "posix", reason="the stand-in for ccx is a shell script")


def input_of(id):
    case = read(CASES / id)
    model = model_of(read_deck(case))
    wanted, _ = planned(model, case.file.channels, plan)
    return written(model, wanted.values(), clock(model, steps(model)))


@installed
def test_it_agrees_with_theory_as_closely_as_the_built_in_solver_must(tmp_path):
    found = run(read(CASES / "VM-071"), backend("calculix"), folder=tmp_path)
    assert found.verdict is Verdict.PASS, found.reason
    assert {row.verdict for row in found.rows} == {Verdict.PASS}
    assert "ALPHA=0" in found.solution.facts["Integrator"]
    assert "seven digits" in found.solution.facts["Precision"]


@installed
def test_a_wrong_datum_in_the_deck_fails(tmp_path):
    case = read(CASES / "VM-071")
    wrong = case.with_deck_of({"k": 1.002 * case.datum("k")})
    found = run(wrong, backend("calculix"), folder=tmp_path)
    assert {row.key for row in found.rows if row.verdict is Verdict.FAIL} >= {"x_under", "x_free"}


def test_a_problem_that_it_cannot_pose_is_neither_a_pass_nor_a_failure(tmp_path):
    found = run(read(CASES / "VM-061"), backend("calculix"), folder=tmp_path)
    if not found.solution.unrepresentable:
        pytest.skip(found.reason)  # it is not installed
    assert {row.verdict for row in found.rows} == {Verdict.UNREPRESENTABLE} == {found.verdict}
    assert "*CONTACT_NODES_TO_SURFACE_ID: the keyword is not supported" in found.reason


def test_channels_that_it_does_not_give_are_named():
    case = read(CASES / "VM-084")
    wanted, missing = planned(model_of(read_deck(case)), case.file.channels, plan)
    assert {"u_load", "v_free", "strain"} < set(wanted)
    assert missing["work"] == "calculix does not report the energy 'external work'"


def test_the_force_of_a_spring_is_the_reaction_of_a_node_that_it_alone_holds():
    case = read(CASES / "VM-091")
    (spring,) = [
        plan(model_of(read_deck(case)), channel)
        for channel in case.file.channels.values()
        if channel.component == "force"
    ]
    slack = {("displacements", f"NODE{node}"): np.array([[[node, 0.0, 0.0, 0.0]]]) for node in (1, 2)}
    model = model_of(read_deck(case))
    along = model.nodes.x0[1] - model.nodes.x0[0]
    pull = 3.0 * along / np.linalg.norm(along)
    held = np.concatenate([[1.0], -pull])[None, None]
    assert spring.value({**slack, ("forces", "NODE1"): held}) == pytest.approx([3.0])
    shared = read(CASES / "VM-182")
    with pytest.raises(NotReportedError, match="spring 1"):
        plan(model_of(read_deck(shared)), Channel(text="", discrete=1, component="force"))


def test_stress_of_a_shell_is_in_its_own_frame():
    case = read(CASES / "D-49")
    model = model_of(read_deck(case))
    hoop = plan(model, case.file.channels["s"])
    corners = model.nodes.x0[list(model.members["ELEMENT_SHELL", 1].rows)]
    along = (corners[1] - corners[0]) / np.linalg.norm(corners[1] - corners[0])
    tensor = 5.0 * np.outer(along, along)
    row = [tensor[0, 0], tensor[1, 1], tensor[2, 2], tensor[0, 1], tensor[0, 2], tensor[1, 2]]
    lower, upper = [[[1, k, *row] for k in range(4)], [[1, k, *6 * [99.0]] for k in range(4)]]
    assert hoop.value({("stresses", "EL1"): np.array([[*lower, *upper]])}) == pytest.approx([5.0])


def test_it_says_how_to_install_what_is_missing(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    assert "apt-get install calculix-ccx" in calculix.found().missing


# The input file


@pytest.mark.parametrize("id", ["VM-156", "VM-182", "D-01", "D-44", "D-51-beam", "D-59"])
def test_no_field_is_longer_than_calculix_reads(id):
    data = [line for line in input_of(id) if not line.startswith("*")]
    assert max(len(field) for line in data for field in line.split(",")) <= 20
    assert max(len(line.split(",")) for line in data) <= 16


@pytest.mark.parametrize("value", [0.0, 1.0, -1.5e-300, 1e-5, 12345678901234567890.0, -0.1234567890123456])
def test_a_number_has_a_point_and_thirteen_digits(value):
    assert "." in real(value)
    assert float(real(value)) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize("id", ["VM-182", "D-01", "D-44", "D-59"])
def test_every_load_and_motion_of_the_step_has_an_amplitude(id):
    lines = input_of(id)
    step = lines[next(i for i, line in enumerate(lines) if line.startswith("*STEP")) :]
    acting = [line for line in step if line.startswith(("*CLOAD", "*BOUNDARY"))]
    assert acting
    assert all("AMPLITUDE=" in line for line in acting)


def test_loads_of_several_curves_on_one_node_become_one(tmp_path):
    load = "*LOAD_NODE_POINT\n        11         1         2       3.0\n*DEFINE_CURVE\n         2\n"
    curve = "                 0.0                 0.0\n              1000.0              1000.0\n"
    text = (CASES / "VM-075" / "deck.k").read_text().replace("*END", f"{load}{curve}*END")
    (tmp_path / "deck.k").write_text(text)
    model = model_of(deck.read(tmp_path / "deck.k", deck.vocabulary()))
    lines = written(model, [], clock(model, 100))
    assert sum(line.startswith("3,1,") for line in lines[-20:]) == 1
    assert "0.,1.,1000.,16." in lines  # 1 + 3 t/200, times the 200 of the first load


def test_a_truss_that_is_held_across_is_a_brick_of_its_stiffness_and_mass():
    model = model_of(read_deck(read(CASES / "D-44")))
    x = np.concatenate([model.nodes.x0, model.added])
    brick = next(line for line in model.elements if not line.startswith("*"))
    corners = x[[int(number) - 1 for number in brick.split(",")[1:]]]
    sides = [np.linalg.norm(corners[i] - corners[0]) for i in (1, 3, 4)]
    assert max(sides[:2]) <= 0.1 * sides[2] * (1.0 + 1e-9)
    (law,) = model.materials.values()
    modulus, density = float(law[2].split(",")[0]), float(law[4])
    assert modulus * sides[0] * sides[1] == pytest.approx(2.1e11 * 1e-4)
    assert density * sides[0] * sides[1] == pytest.approx(7850.0 * 1e-4)


def test_initial_velocities_of_shells_are_not_representable(tmp_path):
    text = (CASES / "D-01" / "deck.k").read_text().replace("         5       &VX", "         3       &VX")
    (tmp_path / "deck.k").write_text(text)
    with pytest.raises(DeckError, match=r"\*INITIAL_VELOCITY_NODE: .*do not reach"):
        model_of(deck.read(tmp_path / "deck.k", deck.vocabulary()))


@pytest.mark.parametrize(("id", "starts_before"), [("D-37", False), ("D-49", True), ("VM-075", False)])
def test_only_loads_on_solids_with_incompatible_modes_start_from_zero(id, starts_before):
    model = model_of(read_deck(read(CASES / id)))
    ticks = clock(model, 100)
    end = model.deck.one("CONTROL_TERMINATION").endtim
    assert ticks.before == pytest.approx(0.5 * ticks.dt if starts_before else 0.0)
    assert ticks.times[-1] == pytest.approx(end)
    t, value = np.array([0.0, 1000.0]), np.array([2.0, 2.0])
    points = np.array(amplitude("A", t, value, ticks)[1].split(","), float).reshape(-1, 2)
    impulse = np.trapezoid(np.interp(ticks.dt * np.arange(101), *points.T), dx=ticks.dt)
    assert impulse == pytest.approx(2.0 * end, rel=1e-9)


def test_large_strains_of_elastic_solids_follow_another_law():
    with pytest.raises(DeckError, match="St Venant-Kirchhoff"):
        model_of(read_deck(read(CASES / "D-43")))


def test_a_mass_that_no_element_holds_gets_a_spring_too_soft_to_act():
    case = read(CASES / "D-01")
    model = model_of(read_deck(case))
    anchors = masses.anchors(model)
    assert [line.split(",")[1] for line in anchors[1::5]] == ["5"] * 3 + ["6"] * 3
    end = case.evaluate("t_end")
    assert [float(line) * end**2 for line in anchors[4::5]] == pytest.approx([2e-10] * 3 + [5e-10] * 3)


@installed
def test_a_free_mass_falls_as_fast_as_digits_show(tmp_path):
    found = run(read(CASES / "D-01"), backend("calculix"), folder=tmp_path)
    errors = {row.key: row.comparison.error_percent for row in found.rows if row not in found.unreported}
    assert len(errors) == 10
    assert max(map(abs, errors.values())) < 1e-3
    assert "Free masses" in found.solution.facts


@pytest.mark.parametrize(("old", "new"), [("B*H**3/12.0", "B*H**3/11.0"), ("0.229", "0.2")])
def test_a_beam_that_is_no_rectangle_is_not_representable(old, new, tmp_path):
    case = read(CASES / "D-51-beam")
    source = case.deck_source()
    assert old in source
    (tmp_path / "deck.k").write_text(source.replace(old, new))
    with pytest.raises(DeckError, match="rectangle"):
        model_of(deck.read(tmp_path / "deck.k", deck.vocabulary()))


# job.dat

TIMES = np.array([0.5, 1.0])


def block(time, *rows, head="displacements (vx,vy,vz) for set NODE2 and time"):
    return "\n".join([f" {head}  {time}", "", *rows, "", ""])


def reading(tmp_path, *blocks):
    (tmp_path / "job.dat").write_text("\n" + "\n".join(blocks))
    return read_dat(tmp_path / "job.dat", TIMES)


GOOD = (
    block("0.5000000E+00", "         2  1.000000E+00 -6.319000-103  0.000000E+00"),
    block("0.1000000E+01", "         2 -2.000000E-05  6.319000+103  0.000000E+00"),
)


def test_exponents_of_three_digits_have_no_letter(tmp_path):
    found = reading(tmp_path, *GOOD)["displacements", "NODE2"]
    assert found[:, 0].tolist() == [[2, 1.0, -6.319e-103, 0.0], [2, -2e-5, 6.319e103, 0.0]]


def test_a_heading_may_have_no_blank_before_its_set(tmp_path):
    head = "equivalent plastic strain (elem, integ.pnt.,pe)for set EL1 and time"
    rows = ["         1   1  1.000000E-03", "         1   2  2.000000E-03"]
    both = [block(time, *rows, head=head) for time in ("0.5000000E+00", "0.1000000E+01")]
    assert reading(tmp_path, *both)["equivalent plastic strain", "EL1"].shape == (2, 2, 3)


@pytest.mark.parametrize(
    ("blocks", "message"),
    [
        ([], "is empty"),
        (GOOD[:1], "displacements of NODE2 ends after 1 of 2 steps"),
        ([GOOD[1]], "at time 1, expected 0.5"),
        ([*GOOD, GOOD[1]], "at time 1, expected no more"),
        ([GOOD[0].replace("1.000000E+00", "         NaN")], "'NaN' is no number"),
        ([GOOD[0].replace("1.000000E+00", "    Infinity")], "'Infinity' is no number"),
        ([GOOD[0].replace("1.000000E+00", "************")], r"'\*+' is no number"),
        (
            [GOOD[0].replace("  1.000000E+00 -", "  1.000000E+00-")],
            "'1.000000E[+]00-6.319000-103' is no number",
        ),
        ([GOOD[0], GOOD[1].replace("  0.000000E+00", "")], "at time 1 is cut off"),
        ([GOOD[0], GOOD[1].replace("-103  0.000000E+00", "-103  0.0000").split("2 -2.0")[0]], "cut off"),
        ([GOOD[0], GOOD[1].rstrip()[:-3]], "'0.000000E' is no number"),
        (["garbage\n"], "no heading of a block: 'garbage'"),
    ],
)
def test_what_is_not_whole_is_refused(blocks, message, tmp_path):
    with pytest.raises(DatError, match=message):
        reading(tmp_path, *blocks)


# Programs that are not well


@pytest.fixture
def stand_in(tmp_path, monkeypatch):
    """Puts a shell script in the place of ccx, and runs a case by it."""

    def install(script):
        folder = tmp_path / "bin"
        folder.mkdir()
        (folder / "ccx").write_text(f"#!/bin/sh\n[ $1 = -v ] && echo This is Version 0 && exit\n{script}\n")
        (folder / "ccx").chmod(0o755)
        monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
        (tmp_path / "run").mkdir()
        return run(read(CASES / "VM-071"), backend("calculix"), folder=tmp_path / "run")

    return install


@programs
@pytest.mark.parametrize(
    ("script", "message"),
    [
        ("echo good; exit 0", "job.dat was not written"),
        ("echo all is well; echo garbage > job.dat", "no heading of a block: 'garbage'"),
        (
            "printf ' displacements (vx) for set NODE1 and time 0.1000000E-01\\n\\n 1 NaN' > job.dat",
            "'NaN' is no number",
        ),
        ("echo ' *ERROR reading *DYNAMIC'; touch job.dat", "it reports an error"),
        ("echo diverged; echo half > job.dat; exit 201", "exit code 201"),
        ("kill -SEGV $$", "SIGSEGV"),
    ],
)
def test_what_a_program_leaves_that_is_not_well_cannot_be_judged(script, message, stand_in):
    found = stand_in(script)
    assert found.verdict is Verdict.ERROR
    assert message in found.reason
    assert found.solution.lost


@programs
def test_the_tail_of_its_output_is_in_the_message(stand_in):
    assert "last words" in stand_in("echo last words; exit 201").reason
