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


@pytest.fixture
def here(tmp_path, monkeypatch):
    """An empty folder to run the command in, with its own ./cases."""
    (tmp_path / "cases").mkdir()
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def ball(here):
    """Makes a copy of VM-061 in ./cases, with other text in its deck; by default its steps are of 0.1 ms."""

    def copy(id="VM-061", density="2.5437", **deck):
        folder = here / "cases" / id
        shutil.copytree(BALL, folder)
        text = (folder / "deck.k").read_text()
        for old, new in {DENSITY: f"RRHO {density:>14}"[: len(DENSITY)], **deck}.items():
            assert old in text
            text = text.replace(old, new)
        (folder / "deck.k").write_text(text)
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
