import hashlib
import json
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from vmharness.execution.call import here as here_and_now

KEYS = ["t_impact", "z_impact", "v_impact", "ke_impact", "t_peak", "z_peak"]
TARGETS = [0.07198157507, -1.0, -27.7848879789, 193.0, 0.1004448598637, -1.5506656122]
OTHER = {
    "id", "title", "folder", "solver", "set", "outcome", "verdict", "reason", "started", "seconds", "cycles", "facts",
    "notes", "sha256", "inputs_sha256", "results",
}  # fmt: skip
COLUMNS = {
    "key", "label", "event", "channel", "unit", "target", "value", "error", "error_percent", "tolerance",
    "tolerance_percent", "share", "verdict", "reason", "published",
}  # fmt: skip


def results(path):
    (case,) = json.loads(Path(path).read_text())["cases"]
    return case, {row["key"]: row for row in case["results"]}


def test_the_manual_from_any_folder(here, vm_process):
    (here / "cases").rmdir()
    process = vm_process("run", "VM-061", "--json", "results.json", "--junit", "results.xml")
    out, err = process.communicate()
    assert process.returncode == 0, out + err
    case, rows = results("results.json")
    assert set(case) == OTHER
    assert (case["id"], case["verdict"]) == ("VM-061", "pass")
    assert case["cycles"] > 60_000
    assert list(rows) == KEYS
    for key, target in zip(KEYS, TARGETS, strict=True):
        row = rows[key]
        assert set(row) == COLUMNS
        assert row["target"] == pytest.approx(target, rel=1e-9)
        assert row["value"] == pytest.approx(target, rel=1e-5)
        assert row["verdict"] == "pass"
    assert rows["z_peak"]["published"]["LS-DYNA"] == -1.5505
    suite = ElementTree.parse("results.xml").getroot().find("testsuite")
    assert [test.get("name") for test in suite.iter("testcase")] == KEYS
    assert (suite.get("failures"), suite.get("errors")) == ("0", "0")
    assert "report: reports/VM-061/index.html" in out
    for name in ("index.html", "README.md"):
        assert (here / "reports" / "VM-061" / name).is_file()
    assert not (here / "reports" / "index.html").exists()  # one case was selected: no index over all


def test_a_wrong_deck_is_1_and_is_run_again_by_lf(ball, vm):
    folder = ball()
    deck = (folder / "deck.k").read_text()
    (folder / "deck.k").write_text(deck.replace("RG            386.0", "RG            386.4"))
    ball(id="sound")
    code, out, _ = vm("run", "-j", "2")
    assert code == 1
    assert "1 fail, 1 pass" in out
    assert "VM-061: fail: deck.k: parameter G = 386.4, but g = 386" in out
    assert "\n  t_impact: 0.07194" in out
    assert "  run it again: vm run VM-061\n" in out
    assert Path("reports/index.html").is_file()
    assert Path("reports/sound/index.html").is_file()

    (folder / "deck.k").write_text(deck)
    code, out, _ = vm("run", "--lf")
    assert code == 0
    assert "sound" not in out
    code, _, err = vm("run", "--lf")
    assert code == 5
    assert "nothing selected" in err


def test_other_data_move_theory_and_solver_and_leave_the_manual_alone(ball, vm):
    ball()
    code, out, _ = vm("run", "VM-061", "--set", "k=2500", "--set", "h=0.5", "--json", "r.json")
    assert code == 0, out
    case, rows = results("r.json")
    assert (case["id"], case["set"]) == ("VM-061", {"k": 2500.0, "h": 0.5})
    assert all(row["published"] == {} for row in rows.values())
    assert rows["z_impact"]["target"] == -0.5
    assert rows["z_peak"]["value"] == pytest.approx(rows["z_peak"]["target"], rel=2e-5)
    assert not Path("reports").exists()
    folder = Path("runs/VM-061@k=2500,h=0.5")
    assert (folder / "index.html").is_file()
    deck = (folder / "deck.k").read_text()
    assert deck.startswith("*KEYWORD")
    assert "&" not in deck
    digest = hashlib.sha256(deck.encode()).hexdigest()
    for page in ("index.html", "README.md"):
        text = (folder / page).read_text()
        assert digest in text
        assert "Where the published difference" not in text


def test_a_datum_that_a_case_does_not_have_is_its_error_alone(ball, vm):
    ball()
    code, out, _ = vm("run", "VM-061", "--set", "kk=2000")
    assert code == 4
    assert "no given datum kk; did you mean k?" in out


def test_sound_cases_run_beside_broken_and_missing_ones(here, ball, vm):
    ball()
    broken = ball(id="broken")
    (broken / "case.toml").write_text("title = 3\n")
    files = ("--json", "r.json", "--junit", "r.xml")
    code, out, _ = vm("run", "VM-061", "broken", "absent", *files, "--no-report")
    assert code == 4
    assert "2 case error, 1 pass" in out
    assert "broken/case.toml" in out
    assert "no case absent" in out
    cases = {case["id"]: case for case in json.loads(Path("r.json").read_text())["cases"]}
    assert {id: case["verdict"] for id, case in cases.items()} == {
        "VM-061": "pass", "broken": "error", "absent": "error",
    }  # fmt: skip
    assert "broken/case.toml" in cases["broken"]["reason"]
    root = ElementTree.parse("r.xml").getroot()
    assert (root.get("tests"), root.get("errors")) == ("8", "2")
    assert not (here / "reports" / "VM-061").exists()


def test_the_index_counts_a_broken_case(ball, vm):
    ball()
    (ball(id="broken") / "case.toml").write_text("title = 3\n")
    assert vm("run")[0] == 4
    text = Path("reports/README.md").read_text()
    assert text.splitlines()[2].startswith("2 cases: 1 ✓ pass, 1 ! error")
    assert "- [broken](broken/README.md): broken/case.toml" in text


def test_a_narrowed_run_links_to_an_index_only_if_there_is_one_and_says_that_it_is_old(ball, vm):
    ball()
    page, link = Path("reports/VM-061/index.html"), 'href="../index.html"'
    _, out, _ = vm("run", "VM-061")
    assert link not in page.read_text()
    assert "earlier run" not in out
    _, out, _ = vm("run")
    assert link in page.read_text()
    assert "earlier run" not in out
    _, out, _ = vm("run", "VM-061")
    assert link in page.read_text()
    assert "the index is from an earlier run; `vm run` without a selection writes it again\n" in out


def test_a_deck_that_the_solver_refuses_could_not_be_judged(ball, vm):
    folder = ball()
    deck = (folder / "deck.k").read_text()
    (folder / "deck.k").write_text(deck.replace("*MAT_ELASTIC", "*MAT_RUBBER"))
    code, out, _ = vm("run", "VM-061", "--json", "r.json")
    assert code == 6
    assert "VM-061: error: deck.k:" in out
    case, rows = results("r.json")
    assert case["verdict"] == "error"
    assert {row["value"] for row in rows.values()} == {None}


def test_a_case_that_takes_too_long_is_6_and_the_next_one_runs(ball, vm):
    ball()
    assert vm("run", "--no-report")[0] == 0  # so that the limit is not spent on compiling kernels
    ball(id="endless", density="7.3E-16")
    code, out, _ = vm("run", "--timeout", "8", "--no-report")
    assert code == 6
    assert "endless: error: not done after 8 s" in out
    assert "1 error, 1 pass" in out
    assert "again: vm run endless --timeout 8" in out


def test_a_folder_that_cannot_be_written_is_4_and_the_verdict_is_told(here, ball, vm):
    ball()
    (here / "occupied").write_text("")
    code, out, _ = vm("run", "VM-061", "--out", "occupied/reports")
    assert code == 4
    assert "not written: the report of VM-061 cannot be written: " in out
    assert "Z-Displacement" in out
    assert out.splitlines()[-1] == "1 pass"
    code, out, _ = vm("run", "VM-061", "--no-report", "--json", "occupied/r.json")
    assert code == 4
    assert "not written: occupied/r.json cannot be written: " in out
    assert "case error" not in out


def test_a_defect_of_a_report_does_not_hide_the_verdict(ball, vm, monkeypatch):
    ball()
    monkeypatch.setattr("vmharness.cli.pipeline.caller", lambda *of: here_and_now)
    monkeypatch.setattr("vmharness.report.write_case", lambda *run, **how: 1 / 0)
    code, out, _ = vm("run", "VM-061")
    assert code == 3
    assert "the page cannot be made: ZeroDivisionError" in Path("reports/VM-061/README.md").read_text()
    assert "defect: the report of VM-061 cannot be written: ZeroDivisionError" in out


def test_a_case_by_its_path(here, ball, vm, monkeypatch):
    folder = ball()
    (here / "elsewhere").mkdir()
    monkeypatch.chdir(here / "elsewhere")
    deck = (folder / "deck.k").read_text()
    (folder / "deck.k").write_text(deck.replace("RH              1.0", "RH            1.001"))
    code, out, _ = vm("run", str(folder), "--no-report")
    assert code == 1
    assert f"again: vm run {folder}\n" in out


def test_a_reader_who_leaves_early_sees_no_traceback(ball):
    ball()
    command = f"{sys.executable} -m vmharness run VM-061 --no-report | head -n 1; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=True)
    assert done.stdout == "cases: cases\n0\n"
    assert done.stderr == ""


def test_results_of_an_earlier_run_do_not_stay_where_nothing_was_selected(ball, vm):
    ball()
    Path("r.json").write_text("of an earlier run")
    assert vm("run", "absent", "--json", "r.json")[0] == 5
    (case,) = json.loads(Path("r.json").read_text())["cases"]
    assert (case["id"], case["outcome"]) == ("absent", "case error")
    assert "no case absent" in case["reason"]
    Path("occupied").write_text("a file")
    code, _, err = vm("run", "absent", "--junit", "occupied/r.xml")
    assert code == 5
    assert "occupied/r.xml cannot be written" in err
