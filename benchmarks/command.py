"""Whole commands beside the least that they could take: `python benchmarks/command.py`."""

import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

VM = str(Path(sys.executable).with_name("vm"))
BARE = "import click\n@click.command()\ndef main(): 'Do nothing.'\nmain()"
RUNS = 7


def seconds(command: list[str], folder: str) -> float:
    """Wall time of one run of `command` in `folder`."""
    began = time.perf_counter()
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.perf_counter() - began


def compare(name: str, command: list[str], beside: str, least: list[str], allowed: float) -> None:
    """Run both in turn, after one run of each that does not count, and print the ratio of the medians."""
    with tempfile.TemporaryDirectory() as folder:
        pairs = [(seconds(command, folder), seconds(least, folder)) for _ in range(RUNS + 1)][1:]
    ours, theirs = (median(column) for column in zip(*pairs, strict=True))
    print(
        f"{name:24} {ours:7.3f} s   {beside:40} {theirs:7.3f} s   ratio {ours / theirs:5.2f}   (at most {allowed:g})"
    )


if __name__ == "__main__":
    python = sys.executable
    compare(
        "vm run VM-061",
        [VM, "run", "VM-061"],
        "import numba, matplotlib.figure",
        [python, "-c", "import numba, matplotlib.figure"],
        allowed=4.0,
    )
    compare(
        "vm --help",
        [VM, "--help"],
        "a bare click program --help",
        [python, "-c", BARE, "--help"],
        allowed=3.0,
    )
