"""Programs of other packages in a work folder."""

import sys
import time
from pathlib import Path

import pytest

from vmharness.execution.program import OUTPUT, ProgramError, run


@pytest.fixture
def folder(tmp_path):
    """A work folder with a space and letters beyond ASCII in its path."""
    path = tmp_path / "Prüf ordner Ω"
    path.mkdir()
    return path


def python(*lines):
    return [sys.executable, "-c", "\n".join(lines)]


def test_it_runs_in_the_folder_and_what_it_prints_is_there(folder):
    printed = run(
        python("import os; print(os.getcwd(), os.environ['LICENCE'])", "open('nodout', 'w').write('x')"),
        folder,
        {"LICENCE": "none"},
    )
    assert printed == f"{folder} none\n"
    assert (folder / OUTPUT).read_text() == printed
    assert (folder / "nodout").read_text() == "x"


def test_a_failure_has_the_exit_code_and_the_last_lines(folder):
    with pytest.raises(ProgramError) as caught:
        run(python("for i in range(40): print('line', i)", "raise SystemExit(3)"), folder)
    assert str(caught.value).startswith("python")
    assert "failed, exit code 3:\n  line 30\n" in str(caught.value)
    assert str(caught.value).endswith("  line 39")


def test_a_crash_names_the_signal(folder):
    with pytest.raises(ProgramError, match="failed, killed by SIGSEGV, and printed nothing"):
        run(python("import os, signal", "os.kill(os.getpid(), signal.SIGSEGV)"), folder)


def test_a_program_that_is_not_there_is_named(folder):
    with pytest.raises(ProgramError, match=r"ls-dyna_smp_d cannot be started: No such file"):
        run(["ls-dyna_smp_d", "i=deck.k"], folder)


def test_what_is_printed_need_not_be_text(folder):
    assert run(python("import sys", "sys.stdout.buffer.write(b'\\xff ok')"), folder).endswith(" ok")


def test_it_has_no_input(folder):
    assert run(python("print(input.__name__, repr(__import__('sys').stdin.read()))"), folder) == "input ''\n"


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="reads /proc")
def test_outside_a_worker_nothing_of_it_outlives_the_call(folder):
    pid = run(["sh", "-c", "sleep 600 & echo $!"], folder).strip()
    stat = Path(f"/proc/{pid}/stat")
    for _ in range(500):
        if not stat.exists() or stat.read_text().rpartition(")")[2].split()[0] == "Z":
            return
        time.sleep(0.02)
    raise AssertionError("the program that it has started still runs")
