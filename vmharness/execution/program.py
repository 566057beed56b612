"""Run an external program in a work folder."""

import os
import subprocess
from collections.abc import Mapping, Sequence
from multiprocessing import parent_process
from pathlib import Path

from vmharness.execution.message import ending
from vmharness.execution.session import end

OUTPUT = "output.txt"  # in the work folder
TAIL = 10  # lines of it in an error


class ProgramError(subprocess.SubprocessError):
    """A program could not be started, or failed; has the exit code and the last lines of its output."""


def run(argv: Sequence[str | Path], folder: Path, environment: Mapping[str, str] | None = None) -> str:
    """Run a program in `folder` and return its output, which is also in the file `OUTPUT` there.

    `environment` is added to that of this process. The program has no input. In a worker, the program and all processes
    that it has started end at the latest with the worker, which has a time limit; elsewhere they end with this call.
    Raises ProgramError if the program cannot be started, or if its exit code is not 0.
    """
    words = [str(word) for word in argv]
    output = folder / OUTPUT
    alone = parent_process() is None  # a worker leads a session already, which its pool ends
    with output.open("wb") as file:
        try:
            process = subprocess.Popen(
                words,
                cwd=folder,
                stdin=subprocess.DEVNULL,
                stdout=file,
                stderr=subprocess.STDOUT,
                env={**os.environ, **(environment or {})},
                start_new_session=alone,
            )
        except OSError as error:
            raise ProgramError(f"{words[0]} cannot be started: {error.strerror}") from None
        try:
            code = process.wait()
        finally:
            if alone:
                end(process.pid)
            process.kill()  # after an interrupt it still runs
            process.wait()
    printed = output.read_text(encoding="utf-8", errors="replace")
    if code:
        raise ProgramError(f"{Path(words[0]).name} failed, {ending(code)}{tail(printed)}")
    return printed


def tail(printed: str) -> str:
    """The last lines of the output, as the end of a message."""
    lines = printed.rstrip().splitlines()[-TAIL:]
    return "".join([":", *(f"\n  {line}" for line in lines)]) if lines else ", and printed nothing"
