"""One cycle of VM-061's time loop, in microseconds, and where it goes: `python benchmarks/cycle.py`."""

import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

from vmharness.backends.builtin.channels import probe_of
from vmharness.backends.builtin.cycles import record
from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.explicit.build import build

CASE = read(Path(__file__).parents[1] / "cases" / "VM-061")


def whole_cycle() -> tuple[float, float]:
    """Microseconds a cycle, with the channels that the case records, and with none."""
    found = []
    for channels in (CASE.file.channels, {}):
        model = build(read_deck(CASE))
        probes = {name: probe_of(model, channel) for name, channel in channels.items()}
        history, _, seconds = record(model, probes)
        found.append(1e6 * seconds / len(history))
    return found[0], found[1]


def one(function: Callable[..., Any], *arguments: Any) -> float:
    """Microseconds of one call."""
    calls = 20_000
    began = time.perf_counter()
    for _ in range(calls):
        function(*arguments)
    return 1e6 * (time.perf_counter() - began) / calls


if __name__ == "__main__":
    whole_cycle()  # compiles, and warms up
    recorded, bare = (median(column) for column in zip(*(whole_cycle() for _ in range(5)), strict=True))
    print(f"whole cycle, recorded     {recorded:6.2f} us   (at most 10)")
    print(f"whole cycle, not recorded {bare:6.2f} us")
    model = build(read_deck(CASE))
    for force in model.forces:
        print(f"  {force.name:24}{one(force.add, model.state):6.2f} us")
    for constraint in model.constraints:
        print(f"  {constraint.name:24}{one(constraint.accelerate, model.state):6.2f} us")
    for name, channel in CASE.file.channels.items():
        print(f"  channel {name:16}{one(probe_of(model, channel)):6.2f} us")
