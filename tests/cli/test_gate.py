"""A gate that is not green by mistake, and says what it looked at."""

import json
import os
import stat
from pathlib import Path
from types import SimpleNamespace

import pytest

from vmharness.cli import summary
from vmharness.cli.commands import run
from vmharness.compare import Tolerance, compare


@pytest.mark.parametrize("command", ["run", "check", "list", "faults"])
def test_an_empty_folder_of_cases_is_not_replaced_by_the_installed_ones(here, vm, command):
    (here / "cases" / "submodule").mkdir()
    code, out, err = vm(command)
    assert code == 5
    assert f"no case in {here / 'cases'}: none of its folders has a case.toml" in err
    assert "pass" not in out


def test_a_broken_case_leaves_no_page_that_says_pass(ball, vm):
    folder = ball()
    assert vm("run", "VM-061")[0] == 0
    page = Path("reports/VM-061/README.md")
    assert "PASS" in page.read_text()
    with (folder / "case.toml").open("a") as file:
        file.write("\n[nonsense]\n")
    code, out, _ = vm("run", "VM-061")
    assert code == 4
    assert "report: reports/VM-061/index.html" in out
    for name in ("README.md", "index.html"):
        text = Path("reports/VM-061", name).read_text()
        assert "PASS" not in text
        assert "NOT JUDGED" in text
        assert "nonsense" in text


def test_a_case_that_cannot_be_read_does_not_stop_the_others(ball, here, vm):
    ball(id="good")
    for name, text in (("deep", "x = " + 20_000 * "[" + 20_000 * "]"), ("huge", "x = " + 5000 * "1")):
        (here / "cases" / name).mkdir()
        (here / "cases" / name / "case.toml").write_text(text)
    code, out, _ = vm("run")
    assert code == 4
    assert "2 case error, 1 pass" in out
    assert "deep/case.toml:1: nested too deeply to be read" in out
    assert vm("check")[0] == 4
    assert vm("list")[0] == 0


def test_every_result_that_fails_is_printed(ball, vm):
    for id in ("A", "B"):
        ball(id=id, **{"RG            386.0": "RG            380.0"})
    code, out, _ = vm("run")
    assert code == 1
    lines = [line for line in out.splitlines() if line.startswith("  t_impact: ")]
    assert len(lines) == 2
    assert "target 0.07198158 s; error +0.7864 %, tolerance 5e-05 %" in lines[0]
    assert any(line.startswith("  z_peak: ") for line in out.splitlines())


def test_a_result_with_a_target_of_zero_is_printed_with_its_value():
    judged = compare(0.0, 1e-9, Tolerance(absolute=1e-6))
    row = SimpleNamespace(key="drift", unit="m", comparison=judged, verdict=judged.verdict)
    assert summary._line(row) == "drift: 1e-09 m, target 0 m"
    failed = compare(0.0, 1e-3, Tolerance(absolute=1e-6))
    line = summary._line(SimpleNamespace(key="drift", unit="m", comparison=failed, verdict=failed.verdict))
    assert line.startswith("drift: 0.001 m, target 0 m; 0.001 differs from 0 by 0.001")


def test_json_to_standard_output_is_all_that_is_there(ball, vm):
    ball()
    code, out, err = vm("run", "VM-061", "--json", "-", "--no-report")
    assert code == 0
    assert json.loads(out)["cases"][0]["id"] == "VM-061"
    assert "1 pass" in err


def test_json_is_written_through_links_and_pipes(ball, here, vm):
    ball()
    target = here / "elsewhere.json"
    target.write_text("old")
    target.chmod(0o600)
    Path("link.json").symlink_to(target)
    assert vm("run", "VM-061", "--json", "link.json", "--no-report")[0] == 0
    assert Path("link.json").is_symlink()
    assert json.loads(target.read_text())["cases"]
    assert stat.S_IMODE(target.stat().st_mode) == 0o600
    assert vm("run", "VM-061", "--json", os.devnull, "--no-report")[0] == 0
    assert not stat.S_ISREG(os.stat(os.devnull).st_mode)


def test_a_title_cannot_command_the_terminal(ball, vm):
    folder = ball()
    text = (folder / "case.toml").read_text().replace('title     = "', 'title     = "\\u001b[2J', 1)
    (folder / "case.toml").write_text(text)
    assert "\x1b" not in vm("list")[1]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["-j", "0"], "0 is not a number of workers; write a number from 1 on, or auto"),
        (["--timeout", "nan"], "nan is not a number of seconds"),
    ],
)
def test_numbers_that_mean_nothing_are_refused(ball, vm, arguments, message):
    ball()
    code, _, err = vm("run", *arguments)
    assert code == 4
    assert message in err


def test_an_id_may_be_written_in_small_letters_and_debug_may_come_last(ball, vm):
    ball()
    code, out, _ = vm("list", "vm-061", "--debug")
    assert code == 0
    assert "VM-061" in out


def test_several_selected_cases_name_their_pages(ball, vm, capsys):
    for id in ("A", "B"):
        ball(id=id)
    _, out, _ = vm("run", "A", "B")
    assert "report: reports/A/index.html" in out
    assert "report: reports/B/index.html" in out
    run._say_where([f"case-{number}" for number in range(7)], Path("reports"), False)
    assert "and 2 more reports: reports/*/index.html" in capsys.readouterr().out
