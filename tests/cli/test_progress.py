import os
import pty
import re
import subprocess
import sys


def test_bars_on_a_terminal_only(ball, vm_process):
    ball(density="7.3E-2")  # 6500 cycles: a few messages of progress
    arguments = ("run", "VM-061", "--no-report")
    piped, _ = vm_process(*arguments).communicate()
    assert "%" not in piped.replace("(%)", "")
    assert "\x1b" not in piped

    ours, terminal = pty.openpty()
    command = [sys.executable, "-m", "vmharness", *arguments]
    with subprocess.Popen(command, stdout=terminal, env={**os.environ, "TERM": "xterm"}) as process:
        os.close(terminal)
        shown = read_all(ours)
    assert process.returncode == 0
    assert re.search(r"VM-061 .*\d+ %", shown)
    assert shown.count("1 pass") == 1


def read_all(descriptor):
    """What a terminal was sent, until its other end is closed."""
    parts = []
    while True:
        try:
            part = os.read(descriptor, 4096)
        except OSError:  # how Linux says that the other end is closed
            part = b""
        if not part:
            os.close(descriptor)
            return b"".join(parts).decode()
        parts.append(part)
