import json
import subprocess
import sys
from pathlib import Path

import pytest

from vmharness.cli import main
from vmharness.cli.commands import run


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["rum"], "no command rum; did you mean run?"),
        (["run", "--sover", "x"], "--sover"),
        (["run", "--solver", "abaqus"], "no solver abaqus; there are: builtin"),
        (["run", "-j", "many"], "many is not a number of workers; write a number from 1 on, or auto"),
        (["run", "-j", "-1"], "-1"),
        (["run", "--timeout", "0"], "timeout"),
        (["run", "--set", "k"], "write NAME=NUMBER"),
        (["run", "--set", "k=1", "--set", "k=2"], "k is set twice"),
        (["run", "-k", "ball and"], "write words with and, or, not"),
        (["list", "--cases", "nowhere"], "no folder nowhere"),
        (["show"], "ID"),
    ],
)
def test_wrong_usage_is_4_with_a_message(here, ball, vm, arguments, message):
    ball()
    code, _, err = vm(*arguments)
    assert code == 4
    assert message in err


def test_list(here, ball, vm):
    ball()
    (here / "cases" / "broken").mkdir()
    (here / "cases" / "broken" / "case.toml").write_text("title =")
    code, out, _ = vm("list")
    assert code == 0
    assert out.splitlines()[0] == "cases: cases"
    (line,) = [line for line in out.splitlines() if line.split()[:1] == ["VM-061"]]
    assert "Transient response of a ball" in line
    assert "penalty" in line
    assert "broken" in out


@pytest.mark.parametrize("command", ["list", "show", "run", "check"])
def test_nothing_selected_is_5(ball, vm, command):
    ball()
    code, _, err = vm(command, "VM-601")
    assert code == 5
    assert "no case VM-601; did you mean VM-061?" in err


def test_help_names_every_command_and_imports_nothing_heavy():
    code = "import sys; from vmharness.cli import main; main(['--help']); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    for name in ("check", "list", "run", "show"):
        assert f"\n  {name} " in done.stdout
    assert not {"numpy", "numba", "matplotlib", "rich", "msgspec", "multiprocessing.pool"} & set(
        done.stdout.split()
    )


def test_the_formats_for_machines_are_options():
    assert {option.name for option in run.command.params} >= {"json", "junit"}


def test_check_and_show(ball, vm):
    folder = ball()
    code, out, _ = vm("check", "VM-061")
    assert (code, "VM-061: ok" in out) == (0, True)
    code, out, _ = vm("show", str(folder))
    assert code == 0
    for text in (
        "sqrt(2*h/g)",
        "0.07198158",
        "z_peak",
        "1973.92",
        "rho = 2.5437",
        "5 *NODE",
        "Surface 1 % too stiff",
    ):
        assert text in out
    (folder / "deck.k").write_text("*KEYWORD\n*NODES\n")
    code, out, _ = vm("check", "VM-061")
    assert code == 4
    assert "deck.k:2: *NODES" in out


def test_a_defect_is_3_and_tells_how_to_see_more(ball, vm, monkeypatch, capsys):
    ball()
    monkeypatch.setattr("vmharness.suite.select.entries", lambda folder: 1 / 0)
    code, _, err = vm("list")
    assert code == 3
    assert "ZeroDivisionError" in err
    assert "vm --debug list" in err
    assert main(["--debug", "list"]) == 3
    assert "Traceback" in capsys.readouterr().err


def test_what_check_finds_is_written_for_machines_too(ball, vm, here):
    folder = ball()
    assert vm("check", "VM-061", "--json", "found.json")[0] == 0
    (found,) = json.loads((here / "found.json").read_text())
    assert found == {"case": "VM-061", "wrong": [], "doubtful": []}
    (folder / "deck.k").write_text("*KEYWORD\n*END\n")
    assert vm("check", "VM-061", "--json", "found.json")[0] == 4
    (found,) = json.loads((here / "found.json").read_text())
    assert "no *NODE in the deck" in found["wrong"][0]


CASES = Path(__file__).parents[2] / "cases"


@pytest.mark.parametrize("id", sorted(path.parent.name for path in CASES.glob("*/case.toml")))
def test_every_case_of_the_manual_is_shown(vm, id):
    code, out, err = vm("show", id, "--cases", str(CASES))
    assert (code, err) == (0, "")
    assert "model: " in out
