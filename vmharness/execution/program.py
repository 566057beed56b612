"""A program of another package, run to its end in a work folder."""

import os
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from vmharness.execution.message import ending

OUTPUT = "output.txt"  # in the work folder
TAIL = 10  # lines of it in an error


class ProgramError(subprocess.SubprocessError):
    """A program could not be started, or failed: how, and its last lines."""


def run(argv: Sequence[str | Path], folder: Path, environment: Mapping[str, str] | None = None) -> str:
    """Run a program in `folder` and return what it printed, which is in `OUTPUT` there, too.

    `environment` is set beside that of this process. Raises ProgramError if the program is not there, or ends with
    another exit code than 0. It has no input, and no time limit but that of the run: it ends with the worker.
    """
    words = [str(word) for word in argv]
    output = folder / OUTPUT
    with output.open("wb") as file:
        try:
            process = subprocess.Popen(
                words,
                cwd=folder,
                stdin=subprocess.DEVNULL,
                stdout=file,
                stderr=subprocess.STDOUT,
                env={**os.environ, **(environment or {})},
            )
        except OSError as error:
            raise ProgramError(f"{words[0]} cannot be started: {error.strerror}") from None
        try:
            code = process.wait()
        finally:
            process.kill()  # an interrupt: it must not go on
            process.wait()
    printed = output.read_text(encoding="utf-8", errors="replace")
    if code:
        raise ProgramError(f"{Path(words[0]).name} failed, {ending(code)}{_tail(printed)}")
    return printed


def _tail(printed: str) -> str:
    """The last lines of what was printed, ready to follow a sentence."""
    lines = printed.rstrip().splitlines()[-TAIL:]
    return "".join([":", *(f"\n  {line}" for line in lines)]) if lines else ", and printed nothing"
