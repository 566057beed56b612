"""Solvers of other packages at the command line: they run, they fail, and nothing of them outlives the command."""

import json
import os
import signal
import tempfile
import time
from pathlib import Path

import pytest

SOLVER = """
import sys
import numpy as np
from pathlib import Path
from vmharness.backends.protocol import Found, Output
from vmharness.deck import DeckError, Finding
from vmharness.execution.program import run
from vmharness.history import History

NAME = "Other code"
# A program that starts another one, which makes a group of its own, and waits.
CHILD = '''
import os, subprocess, sys, time
from pathlib import Path
where = Path({here!r})
other = subprocess.Popen([sys.executable, "-c", "import os, time; os.setpgid(0, 0); time.sleep(600)"])
print("starting", flush=True)
(where / "pids").write_text(f"{{os.getpid()}} {{other.pid}}")
time.sleep(600)
'''

def found():
    return Found(version="R14", where="/opt/other", missing={missing!r})

def review(deck, channels):
    return [Finding(DeckError(f"[channels] {{name}}: it has no such output")) for name in channels]

def reports(deck):
    return {{}}

def solve(job):
    if {fails!r}:
        run([sys.executable, "-c", "print('no licence'); raise SystemExit(2)"], job.folder)
    if {waits!r}:
        run([sys.executable, "-c", CHILD], job.folder)
    t = np.linspace(0.0, 0.11, 200)
    return Output(History(t, {{name: np.cos(40.0 * t) for name in job.channels}}), cycles=200)
"""


@pytest.fixture
def other(installed, tmp_path, monkeypatch):
    """Installs the solver `other`, which waits, fails, is missing or raises in one function; its work folders lie in a strange place."""
    temporary = tmp_path / "Ablage für Läufe Ω"
    temporary.mkdir()
    monkeypatch.setenv("TMPDIR", str(temporary))
    monkeypatch.setattr(tempfile, "tempdir", None)

    def install(waits=False, fails=False, missing="", raises=""):
        source = SOLVER.format(here=str(tmp_path), waits=waits, fails=fails, missing=missing)
        if raises:
            source += f"\ndef {raises}(*given):\n    raise KeyError('x')\n"
        installed("other", source)

    return install


def started(tmp_path):
    """The process ids of the program and of what it has started, once they are there."""
    for _ in range(3000):
        if (tmp_path / "pids").exists() and (found := (tmp_path / "pids").read_text()):
            return [int(pid) for pid in found.split()]
        time.sleep(0.02)
    raise AssertionError("the program did not start")


def alive(pids):
    """Those that still run; one that has ended and is not waited for yet does not."""
    found = []
    for pid in pids:
        stat = Path(f"/proc/{pid}/stat")
        if stat.exists() and stat.read_text().rpartition(")")[2].split()[0] != "Z":
            found.append(pid)
    return found


def gone(pids):
    """Whether all end, on a busy machine within a minute."""
    for _ in range(3000):
        if not alive(pids):
            return True
        time.sleep(0.02)
    return False


def test_a_case_is_run_by_a_solver_of_another_package(ball, vm, here, other):
    other()
    ball()
    code, _, _ = vm("run", "VM-061", "--solver", "other", "--json", "r.json")
    assert code == 1  # what it gives is not the theory
    (case,) = json.loads((here / "r.json").read_text())["cases"]
    assert case["solver"] == "Other code R14"
    assert (here / "reports/VM-061/model.svg").is_file()


def test_check_asks_the_solver_what_it_cannot_represent(ball, vm, other):
    other()
    ball()
    code, out, _ = vm("check", "VM-061", "--solver", "other")
    assert code == 4
    assert "[channels] z: it has no such output" in out
    assert vm("check", "VM-061")[0] == 0


def test_a_solver_that_is_missing_leaves_a_case_unjudged_and_says_how_to_install_it(ball, vm, other):
    other(missing="no program other; install it from its vendor")
    ball()
    code, out, _ = vm("run", "VM-061", "--solver", "other", "--no-report")
    assert code == 6
    assert "Other code cannot run here: no program other; install it from its vendor" in out


def test_a_solver_that_cannot_be_imported_leaves_a_case_unjudged(ball, vm, installed):
    installed("broken", "import no_such_library")
    ball()
    code, out, _ = vm("run", "VM-061", "--solver", "broken", "--no-report")
    assert code == 6
    assert "No module named 'no_such_library'" in out


def test_what_a_program_printed_last_is_told_and_its_files_are_kept(ball, vm, other):
    other(fails=True)
    ball()
    code, out, _ = vm("run", "VM-061", "--solver", "other", "--no-report")
    assert code == 6
    assert "failed, exit code 2:\n  no licence (its files: " in out
    folder = Path(out.partition("its files: ")[2].partition(")")[0])
    assert (folder / "output.txt").read_text() == "no licence\n"


def test_the_doctor_shows_every_solver_and_why_one_is_not_there(vm, installed, other):
    other(missing="no program other on PATH")
    installed("broken", "import no_such_library")
    code, out, _ = vm("doctor")
    assert code == 0
    lines = {line.split()[0]: line for line in out.splitlines() if line.split()}
    assert "explicit" in lines["builtin"]
    assert "no: no program other on PATH" in lines["other"]
    assert "no_such_library" in lines["broken"]


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="reads /proc")
def test_what_stands_in_brackets_is_printed(vm, monkeypatch):
    """Tables take [opensees] as a text, not as a style."""
    monkeypatch.setattr("importlib.util.find_spec", lambda name, package=None: None)
    _, out, _ = vm("doctor")
    assert "vmharness[opensees]" in "".join(out.split())


def test_a_program_dies_with_its_time_limit_and_all_that_it_has_started(ball, vm, other, tmp_path):
    other(waits=True)
    ball()
    code, out, _ = vm("run", "VM-061", "--solver", "other", "--no-report", "--timeout", "6")
    assert code == 6
    assert "not done after 6 s, the time limit (its files: " in out
    assert gone(started(tmp_path))


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="reads /proc")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGKILL"])
def test_a_program_dies_with_the_command(ball, vm_process, other, tmp_path, name):
    other(waits=True)
    ball()
    process = vm_process("run", "VM-061", "--solver", "other", "--no-report")
    pids = started(tmp_path)
    assert alive(pids) == pids
    if name == "SIGINT":
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
    else:
        process.send_signal(signal.Signals[name])
    process.communicate()
    assert gone(pids)


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="reads /proc")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_a_program_dies_with_vm_solve(falling, vm_process, other, tmp_path, name):
    other(waits=True)
    process = vm_process("solve", str(falling), "--solver", "other")
    pids = started(tmp_path)
    assert alive(pids) == pids
    process.send_signal(signal.Signals[name])
    process.communicate()
    assert process.returncode == 2
    assert gone(pids)


def test_vm_solve_says_how_to_install_a_solver_that_is_missing(falling, vm, other):
    other(missing="no program other; install it from its vendor")
    code, _, err = vm("solve", str(falling), "--solver", "other")
    assert code == 6
    assert "Other code cannot run here: no program other; install it from its vendor" in err


@pytest.mark.parametrize(
    ("call", "arguments", "expected"),
    [
        ("found", ("run", "VM-061", "--no-report"), 6),
        ("solve", ("run", "VM-061", "--no-report"), 6),
        ("review", ("check", "VM-061"), 4),
        ("review", ("check", "fall.k"), 6),
        ("reports", ("solve", "fall.k"), 6),
        ("solve", ("solve", "fall.k"), 6),
        ("supported", ("keywords", "NODE"), 6),
        ("found", ("faults", "VM-061"), 6),
    ],
)
def test_an_exception_in_a_solver_is_its_own_error(ball, falling, vm, other, call, arguments, expected):
    other(raises=call)
    ball()
    code, out, err = vm(*arguments, "--solver", "other")
    assert code == expected
    assert f"solver other: {call} failed: KeyError: 'x'" in out + err
    assert "defect" not in out + err


def test_the_doctor_outlives_a_solver_that_raises(vm, other):
    other(raises="found")
    code, out, _ = vm("doctor")
    assert code == 0
    lines = {line.split()[0]: line for line in out.splitlines() if line.split()}
    assert "solver other: found failed: KeyError: 'x'" in lines["other"]
    assert "explicit" in lines["builtin"]


def test_support_is_that_of_the_chosen_solver(ball, vm, other):
    other()
    ball()
    remark = "asks for output files; no effect on results"
    assert remark in vm("keywords", "DATABASE_BNDOUT")[1]
    code, out, _ = vm("keywords", "DATABASE_BNDOUT", "--solver", "other")
    assert (code, out.splitlines()[0]) == (0, "*DATABASE_BNDOUT")
    assert remark in vm("show", "VM-061")[1]
    code, out, _ = vm("show", "VM-061", "--solver", "other")
    assert code == 0
    assert remark not in out


def test_a_study_of_another_solver_says_that_no_fault_of_it_is_planted(ball, vm, other):
    other()
    ball()
    code, out, err = vm("faults", "VM-061", "--solver", "other", "-j", "1")
    assert code == 6
    assert "VM-061: the run without a fault does not pass" in err
    assert "no fault of the solver was planted" in out
    assert "0 of 0" not in out
