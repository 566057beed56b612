"""All figures of speed, as the table of README.md and the chart speed.svg: `python benchmarks/speed.py`."""

import os
import platform
import sys
from datetime import date
from pathlib import Path

import elements
import matplotlib
import plain_c
import reader
import sizes
from matplotlib.figure import Figure
from meshes import moving, sheet

# Million element-cycles a second that are wanted; a line per kind of element and law.
WANTED = {
    "shell BT, 3 points, elastic": 10.0,
    "shell BT, 3 points, plastic bilinear (024)": 6.0,
    "solid one-point, elastic": 5.0,
    "solid one-point, plastic bilinear (024)": 4.0,
    "truss, elastic": 20.0,
}
FACTOR = 1.6  # between the quickest and the slowest size
PLAIN_C = "plain C (shell.c), shell BT, elastic"


def processor() -> str:
    """The processor's name where the system tells it."""
    lines = Path("/proc/cpuinfo").read_text().splitlines() if sys.platform == "linux" else []
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return f"{next(names, platform.processor())}, {os.cpu_count()} cores"


def speeds() -> dict[str, float]:
    """Million element-cycles a second by line, the plain C loop first where there is gcc."""
    c = plain_c.speed(moving(sheet(elements.ELASTIC)))
    found = {PLAIN_C: c[0]} if c else {}
    return found | {name: elements.speed(moving(mesh())) for name, mesh in elements.LINES.items()}


def table(rates: dict[str, float], by_size: list[tuple[int, float, float]]) -> None:
    """Print the figures in Markdown."""
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")
    print(
        f"Measured {date.today()} on {processor()}; load before the run {load:.1f}, the quickest of 30 cycles each.\n"
    )
    print("| mesh | million element-cycles/s | wanted | beside plain C |\n|---|---:|---:|---:|")
    c = rates.get(PLAIN_C, float("nan"))
    for name, rate in rates.items():
        print(f"| {name} | {rate:.1f} | {WANTED.get(name, '')} | {rate / c:.2f} |")
    print("\n| elastic shells | ns per element-cycle | peak memory, GB |\n|---:|---:|---:|")
    for shells, ns, memory in by_size:
        print(f"| {shells} | {ns:.0f} | {memory:.2f} |")
    ns = [row[1] for row in by_size]
    print(f"\nSlowest size beside the quickest: {max(ns) / min(ns):.2f} (wanted at most {FACTOR}).")
    print(f"100 000 nodes and 100 000 shells are read in {reader.reading():.2f} s (wanted about 1 s).")
    cold, warm = reader.first_runs()
    print(f"Solving VM-061 takes {cold:.1f} s with its kernels to compile, {warm:.2f} s with them compiled.")


def chart(rates: dict[str, float], by_size: list[tuple[int, float, float]]) -> Figure:
    """Speeds as bars with what is wanted, and time per element-cycle over the size."""
    figure = Figure(figsize=(10, 7), layout="constrained")
    bars, size = figure.subplots(2, 1, height_ratios=(3, 1.4))
    names = list(rates)[::-1]
    drawn = bars.barh(
        names, [rates[n] for n in names], color=["0.6" if n == PLAIN_C else "C0" for n in names]
    )
    bars.bar_label(drawn, fmt="%.1f", padding=6)
    bars.margins(x=0.08)
    wanted = [(WANTED[n], i) for i, n in enumerate(names) if n in WANTED]
    bars.plot(*zip(*wanted, strict=True), "|", color="C3", markersize=16, markeredgewidth=2, label="wanted")
    bars.set_xlabel("million element-cycles per second, one core, whole cycle")
    bars.legend(loc="lower right")
    shells, ns, _ = zip(*by_size, strict=True)
    size.plot(shells, ns, "o-", label="elastic shells")
    size.axhline(FACTOR * min(ns), color="C3", linestyle="--", label=f"{FACTOR} times the quickest")
    size.set(xscale="log", ylim=(0, None), xlabel="shells", ylabel="ns per element-cycle")
    size.legend(loc="lower right")
    return figure


if __name__ == "__main__":
    matplotlib.rcParams["svg.hashsalt"] = "speed"  # the same figures, the same file
    rates, by_size = speeds(), sizes.figures()
    table(rates, by_size)
    chart(rates, by_size).savefig(Path(__file__).with_name("speed.svg"), metadata={"Date": None})
