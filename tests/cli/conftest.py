import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from vmharness.cli import main

ROOT = Path(__file__).parents[2]
BALL = ROOT / "cases" / "VM-061"
DENSITY = "RRHO         7.3E-4"  # of the wall, whose nodes are held: it sets the time step, and nothing else
DATUM = "rho = { value = 7.3e-4,"  # the same in the data of the case

FALL = """*KEYWORD
*TITLE
a ball that falls
*CONTROL_TERMINATION
1.0
*NODE
1,0.0,0.0,0.0,7,7
2,1.0,0.0,0.0
*PART
spring
1,1,1
*SECTION_DISCRETE
1


*MAT_SPRING_ELASTIC
1,1e-6
*ELEMENT_DISCRETE
1,1,1,2
*ELEMENT_MASS
1,2,2.0
*CONTROL_TIMESTEP
0.0,0.9,,,,1
*DEFINE_CURVE
1
0.0,0.001
2.0,0.001
*DEFINE_CURVE
2
0.0,10.0
2.0,10.0
*LOAD_BODY_Z
2,1.0
*DATABASE_HISTORY_NODE
2
*DATABASE_NODOUT
0.25
"""


@pytest.fixture
def here(tmp_path, monkeypatch):
    """An empty folder to run the command in, with its own ./cases."""
    (tmp_path / "cases").mkdir()
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def ball(here):
    """Makes a copy of VM-061 in ./cases, with another density and other text in its deck; its steps are of 0.1 ms."""

    def copy(id="VM-061", density="2.5437", **deck):
        folder = here / "cases" / id
        shutil.copytree(BALL, folder)
        text = (folder / "deck.k").read_text()
        for old, new in {DENSITY: f"RRHO {density:>14}"[: len(DENSITY)], **deck}.items():
            assert old in text
            text = text.replace(old, new)
        (folder / "deck.k").write_text(text)
        given = (folder / "case.toml").read_text()
        assert DATUM in given
        (folder / "case.toml").write_text(given.replace(DATUM, f"rho = {{ value = {float(density)!r},"))
        return folder

    return copy


@pytest.fixture
def vm(capsys):
    """Runs the command in this process: exit code, stdout, stderr."""

    def run(*arguments):
        code = main(arguments)
        printed = capsys.readouterr()
        assert "Traceback" not in printed.out + printed.err
        return code, printed.out, printed.err

    return run


def _heed_interrupts():
    """Ctrl-C is ignored by what a shell has put in the background, and by all that it starts."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.fixture
def vm_process():
    """Starts the command as a process of its own, in a process group of its own."""
    started = []

    def start(*arguments):
        process = subprocess.Popen(
            [sys.executable, "-m", "vmharness", *arguments],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), os.environ.get("PYTHONPATH", "")])},
            start_new_session=True,
            preexec_fn=_heed_interrupts,
        )
        started.append(process)
        return process

    yield start
    for process in started:
        process.kill()
        process.communicate()


@pytest.fixture
def falling(here):
    """Writes the deck of a mass in free fall, fall.k: its path."""
    path = here / "fall.k"
    path.write_text(FALL)
    return path
