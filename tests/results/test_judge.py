"""`vm judge`: results made elsewhere are judged as those of a run, and what they do not hold is said."""

import json

import numpy as np
import pytest

from vmharness import run
from vmharness.cli import main
from vmharness.collect import collect
from vmharness.compare import Verdict
from vmharness.result import Solution

IMPACT = {"t_impact", "z_impact", "v_impact", "ke_impact"}


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    """A folder without cases: those of the package are judged."""
    monkeypatch.chdir(tmp_path)


def judge(*arguments):
    """The exit code, and the verdicts of the results by key, of a case."""
    pages = [] if "--out" in arguments else ["--no-report"]
    code = main(["judge", *map(str, arguments), "--json", "judged.json", *pages])
    with open("judged.json", encoding="utf-8") as file:
        (case,) = json.load(file)["cases"]
    return code, {result["key"]: result["verdict"] for result in case["results"]}, case


def test_a_csv_file_with_all_digits_passes_as_the_run_does(solved, tmp_path, capsys):
    case, history = solved("VM-061")
    history = history.samples(slice(None, None, 5))
    history.to_csv(tmp_path / "ball.csv")
    code, verdicts, judged = judge("VM-061", "ball.csv")
    assert code == 0
    assert set(verdicts.values()) == {"pass"}
    direct = run.judge(case, Solution("x", history))
    assert [result["value"] for result in judged["results"]] == [row.comparison.value for row in direct.rows]
    assert "Read from ball.csv: every 8.47021e-06, 17 digits: z, v, contact_force" in capsys.readouterr().out


def test_columns_of_other_names_are_mapped(solved, tmp_path, capsys):
    _, history = solved("VM-061")
    history = history.samples(slice(None, None, 5))
    renamed = type(history)(history.time, {"Z of the ball": history["z"], "force": history["contact_force"]})
    renamed.to_csv(tmp_path / "ball.csv")
    named = ["--column", "z=Z of the ball", "--column", "contact_force=force"]
    code, verdicts, _ = judge("VM-061", "ball.csv", *named, "--out", "pages")
    assert code == 0
    assert {key for key, verdict in verdicts.items() if verdict == "pass"} == {
        "t_impact",
        "z_impact",
        "t_peak",
        "z_peak",
    }
    assert verdicts["v_impact"] == verdicts["ke_impact"] == "not reported"
    said = capsys.readouterr().out
    assert (
        "not reported: v is not among the columns time, Z of the ball, force; name its column with --column"
        in said
    )
    assert (
        "4 of 6 results are within their tolerances, 2 not reported"
        in (tmp_path / "pages/VM-061/README.md").read_text()
    )


def test_what_is_in_no_file_is_not_reported_with_what_would_give_it(solved, lsdyna, tmp_path, capsys):
    _, history = solved("VM-061")
    history = history.samples(slice(None, None, 100))
    lsdyna.nodout(
        tmp_path / "nodout", history.time, {5: {"z-displacement": history["z"], "z-velocity": history["v"]}}
    )
    lsdyna.glstat(tmp_path / "glstat", history.time, {"kinetic energy": history["kinetic"]})
    code, verdicts, _ = judge("VM-061", "nodout", "glstat")
    assert {key for key, verdict in verdicts.items() if verdict == "not reported"} == IMPACT
    assert code == 1  # five digits do not reach the tolerance of the peak
    said = capsys.readouterr().out
    assert "VM-061: LS-DYNA smp.131 d  R14.1" in said
    assert "not reported: contact_force needs *DATABASE_RCFORC (binout or rcforc)" in said
    assert "t_impact: not reported: contact_force needs *DATABASE_RCFORC" in said
    assert "not reported: ratio is not in glstat, which has no ratio energy: needs *DATABASE_GLSTAT" in said


def test_if_nothing_can_be_judged_the_command_is_not_green(solved, lsdyna, tmp_path, capsys):
    _, history = solved("VM-061")
    history = history.samples(slice(None, None, 1000))
    lsdyna.glstat(tmp_path / "glstat", history.time, {"kinetic energy": history["kinetic"]})
    code, verdicts, judged = judge("VM-061", "glstat")
    assert code == 6
    assert set(verdicts.values()) == {"not reported"}
    assert judged["verdict"] == "error"
    (tmp_path / "empty.csv").write_text("time,unknown\n0,1\n1,2\n")
    code, _, _ = judge("VM-061", "empty.csv")
    assert code == 6
    assert "none of its channels is in empty.csv" in capsys.readouterr().out


# Cases with tolerances that five digits reach: motion, energies, walls, springs' masses, stresses, supports, joints.
WRITTEN = {
    "VM-084": ({}, set()),
    "VM-265": ({"normals": {1: 1.0}}, {"t_impact", "impulse"}),
    "D-59": ({}, set()),
    "D-49": ({}, set()),
    "D-44": ({"areas": 1.0}, {"t_plastic", "p_plastic"}),
    "D-45": ({"driven": None}, {"p_plastic"}),
    "D-31": ({}, set()),
    "D-40": ({}, set()),
}


@pytest.mark.parametrize("id", WRITTEN)
def test_a_run_written_as_ls_dyna_does_passes_with_the_digits_that_it_has(written, id):
    options, unreported = dict(WRITTEN[id][0]), WRITTEN[id][1]
    if "normals" in options:
        options["normals"] = {1: _normal(id)}
    if "areas" in options:
        options["areas"] = _deck(id).all("SECTION_BEAM")[0].a
    if "driven" in options:
        deck = _deck(id)
        options["driven"] = deck.find(
            "SET_NODE_LIST", sid=deck.first("BOUNDARY_PRESCRIBED_MOTION_SET").nsid
        ).nodes.tolist()
    case, history, folder = written(id, **options)
    judged, direct = (
        run.judge(case, collect(case, sorted(folder.iterdir()))),
        run.judge(case, Solution("x", history)),
    )
    assert judged.verdict is Verdict.PASS
    assert {row.key for row in judged.unreported} == unreported
    for row, other in zip(judged.rows, direct.rows, strict=True):
        if row.key not in unreported:
            scale = max(abs(other.comparison.target), abs(other.comparison.value))
            assert row.comparison.value == pytest.approx(
                other.comparison.value, rel=1e-3, abs=1e-4 * scale
            ), row.key


def test_a_binout_in_double_precision_passes_as_the_run_does(solved, binary, tmp_path):
    case, history = solved("VM-061")
    history = history.samples(slice(None, None, 5))
    column = lambda name: history[name][:, None]  # noqa: E731
    zero = np.zeros((len(history), 2))
    force = np.column_stack([history["contact_force"], -history["contact_force"]])  # of both sides
    binary.binout(
        tmp_path / "binout",
        history.time,
        {
            "/nodout": ({"ids": [5]}, {"z_displacement": column("z"), "z_velocity": column("v")}),
            "/glstat": ({}, {"kinetic_energy": history["kinetic"]}),
            "/rcforc": (
                {"ids": [1, 1], "side": [0, 1]},
                {"x_force": zero, "y_force": zero, "z_force": force},
            ),
        },
        "d",
    )
    judged = run.judge(case, collect(case, [tmp_path / "binout"]))
    direct = run.judge(case, Solution("x", history))
    assert judged.verdict is Verdict.PASS
    assert not judged.unreported
    assert [row.comparison.value for row in judged.rows] == [row.comparison.value for row in direct.rows]


def _t01(binary, path, history, nodes):
    energies, motion = np.zeros((len(history), 12)), np.zeros((len(history), len(nodes), 2))
    energies[:, 0], energies[:, 8] = history["strain"], history["work"]
    for place, name in enumerate(nodes.values()):
        motion[:, place, 0] = history[name]
    before = history.time - np.diff(history.time, prepend=0.0) / 2.0
    motion[:, -1, 1] = np.interp(before, history.time, history["v_free"])
    parts = ([1], [1], np.zeros((len(history), 1, 1)))
    binary.t01(path, history.time, np.diff(history.time)[0], energies, parts, (list(nodes), [1, 4], motion))


def _d3plot(binary, path, history, nodes):
    x0 = np.zeros((len(nodes), 3))
    motion = np.zeros((3, len(history), len(nodes), 3))
    for place, name in enumerate(nodes.values()):
        motion[0, :, place, 0] = history[name]
    motion[1, :, -1, 0] = history["v_free"]
    energies = np.zeros((len(history), 6))
    energies[:, 1] = history["strain"]
    binary.d3plot(path, history.time, (list(nodes), motion), x0, energies, files=2)


@pytest.mark.parametrize(
    ("write", "file", "unreported"), [(_t01, "T01", set()), (_d3plot, "d3plot", {"work_1"})]
)
def test_results_of_a_bar_in_single_precision_pass(solved, binary, tmp_path, write, file, unreported):
    case, history = solved("VM-084")
    nodes = {1: "u_load", 401: "u_mid", 801: "u_free"}
    write(binary, tmp_path / f"case{file}", history, nodes)
    solution = collect(case, [tmp_path / f"case{file}"])
    assert {solution.sources[name].format for name in (*nodes.values(), "v_free", "strain")} == {file}
    judged = run.judge(case, solution)
    assert judged.verdict is Verdict.PASS
    assert {row.key for row in judged.unreported} == unreported


def _deck(id):
    from pathlib import Path

    from vmharness.case import read
    from vmharness.case.deck import read_deck

    return read_deck(read(Path(__file__).parents[2] / "cases" / id))


def _normal(id):
    """The component of the outward normal of the wall along x."""
    wall = next(entry for entry in _deck(id).entries if entry.keyword.name.startswith("RIGIDWALL"))
    return float(np.sign(wall.xh - wall.xt))


def test_every_channel_says_how_well_it_is_known(written):
    case, history, folder = written("VM-084")
    sources = collect(case, sorted(folder.iterdir())).sources
    assert {
        name: (source.format, source.digits)
        for name, source in sources.items()
        if name in ("u_mid", "strain")
    } == {
        "u_mid": ("nodout", 5.0),
        "strain": ("glstat", 6.0),
    }
    assert sources["u_mid"].interval == pytest.approx(np.diff(history.time).max(), rel=1e-3)
    assert "t_n" in sources["u_mid"].scheme


def test_files_of_a_restart_are_joined_whatever_their_order(written, lsdyna, solved, tmp_path):
    case, history, folder = written("VM-084")
    half = len(history) // 2
    nodes = {
        n: name
        for name, channel in case.file.channels.items()
        if (n := channel.node) and "displacement" in channel.component
    }
    for file, part in (("later", slice(half - 20, None)), ("earlier", slice(None, half))):
        some = history.samples(part)
        lsdyna.nodout(
            tmp_path / file, some.time, {n: {"x-displacement": some[name]} for n, name in nodes.items()}
        )
    joined = collect(case, [tmp_path / "later", tmp_path / "earlier"]).history
    whole = collect(case, [folder / "nodout"]).history
    np.testing.assert_array_equal(joined["u_mid"], whole["u_mid"])
    np.testing.assert_array_equal(joined.time, whole.time)


def test_channels_at_other_instants_are_measured_at_their_own(solved, lsdyna, tmp_path):
    case, history = solved("VM-061")
    fine, coarse = history.samples(slice(None, None, 10)), history.samples(slice(None, None, 130))
    zero = np.zeros(len(fine))
    lsdyna.rcforc(
        tmp_path / "rcforc",
        fine.time,
        {1: {"x-force": zero, "y-force": zero, "z-force": fine["contact_force"]}},
    )
    lsdyna.nodout(
        tmp_path / "nodout", coarse.time, {5: {"z-displacement": coarse["z"], "z-velocity": coarse["v"]}}
    )
    solution = collect(case, [tmp_path / "nodout", tmp_path / "rcforc"])
    assert solution.history.time_of("contact_force").size == len(fine)
    assert solution.history.time_of("z").size == len(coarse)
    rows = {row.key: row for row in run.judge(case, solution).rows}
    assert rows["t_impact"].comparison.value == pytest.approx(rows["t_impact"].comparison.target, rel=1e-5)
    assert rows["v_impact"].comparison.value == pytest.approx(rows["v_impact"].comparison.target, rel=1e-3)


def test_events_behind_the_end_of_the_files_cannot_be_judged(solved, tmp_path, capsys):
    _, history = solved("VM-061")
    history.samples(slice(None, 47000, 5)).to_csv(tmp_path / "ball.csv")
    code, verdicts, _ = judge("VM-061", "ball.csv")
    assert code == 6
    assert {key for key, verdict in verdicts.items() if verdict == "pass"} == IMPACT
    assert verdicts["z_peak"] == "error"
    assert "ball.csv ends at t = 0.0796" in capsys.readouterr().out


def test_events_before_the_beginning_of_the_files_cannot_be_judged(solved, tmp_path, capsys):
    _, history = solved("VM-061")
    history.samples(slice(47000, None, 5)).to_csv(tmp_path / "ball.csv")
    code, verdicts, _ = judge("VM-061", "ball.csv")
    assert code == 6
    assert {key for key, verdict in verdicts.items() if verdict == "pass"} == {"t_peak", "z_peak"}
    assert verdicts["v_impact"] == "error"
    assert "ball.csv begins at t = 0.0796" in capsys.readouterr().out


def test_of_two_states_nothing_can_be_judged(solved, tmp_path, capsys):
    _, history = solved("VM-061")
    history.samples([0, -1]).to_csv(tmp_path / "ball.csv")
    code, verdicts, _ = judge("VM-061", "ball.csv")
    assert code == 6
    assert set(verdicts.values()) == {"error"}
    assert "ball.csv has only 2 states" in capsys.readouterr().out


def test_a_damaged_file_is_named_with_its_line(solved, tmp_path, capsys):
    _, history = solved("VM-061")
    history.samples(slice(None, None, 1000)).to_csv(tmp_path / "ball.csv")
    lines = (tmp_path / "ball.csv").read_text().split("\n")
    lines[7] = lines[7].replace(lines[7].split(",")[1], "****")
    (tmp_path / "ball.csv").write_text("\n".join(lines))
    code, _, _ = judge("VM-061", "ball.csv")
    assert code == 6
    assert "VM-061: error: ball.csv:8: z is ****: the number did not fit its field" in capsys.readouterr().out


def test_a_folder_with_a_folder_for_each_case_is_judged_whole(written, tmp_path, capsys):
    for id in ("VM-084", "D-59"):
        written(id)
    (tmp_path / "results of a run" / "D-99").mkdir()
    assert main(["judge", str(tmp_path / "results of a run"), "--out", "pages"]) == 0
    said = capsys.readouterr()
    assert "2 pass" in said.out
    assert "D-99: no case D-99" in said.err
    assert (tmp_path / "pages" / "index.html").is_file()


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["VM-061", "missing"], 4, "missing: no such file"),
        (
            ["VM-061"],
            4,
            "VM-061: no such folder; name a case and its files, or a folder of folders",
        ),
        (["VM-0615", "hello"], 4, "no case VM-0615; did you mean VM-061"),
        (["VM-061", "hello"], 6, "hello: not a result file that is known; there are: binout, bndout, CSV"),
        (["."], 5, "no sub-folder of . has the id of a case"),
        (["VM-061", "hello", "--column", "z"], 4, "z= is not of the form CHANNEL=COLUMN"),
    ],
)
def test_wrong_usage_is_said(tmp_path, capsys, arguments, code, message):
    (tmp_path / "hello").write_text("hello\n")
    assert main(["judge", *arguments, "--no-report"]) == code
    said = capsys.readouterr()
    assert message in said.out + said.err
    assert "Traceback" not in said.err
