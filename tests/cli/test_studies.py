import json
import os
import signal
import time

import pytest

from vmharness import __version__
from vmharness.case import read
from vmharness.studies import gather
from vmharness.studies.converge.runs import variants
from vmharness.studies.sources import sources

HALF = "levels  = [45, 90, 180, 360, 720]", "levels  = [90, 180, 360]"


@pytest.fixture
def study(ball, tmp_path, monkeypatch):
    """VM-061 with three levels, and a store of outcomes of its own."""
    monkeypatch.setattr(gather, "root", lambda: tmp_path / "store")
    folder = ball()
    change(folder, HALF, ("t_peak/(1e4*0.9*L)", "t_peak/(5e3*0.9*L)"))
    return folder


def change(folder, *pairs):
    text = (folder / "case.toml").read_text()
    for old, new in pairs:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    (folder / "case.toml").write_text(text)


def test_converge_says_the_order_and_leaves_it_for_the_page(study, here, vm):
    code, printed, _ = vm("converge", "VM-061", "--json", "found.json")
    assert code == 0
    assert "The time step is refined on 3 levels; its size is t_impact/(N + 0.2)." in printed
    found = json.loads((here / "found.json").read_text())
    assert found == json.loads((here / "reports/VM-061/studies/converge.json").read_text())
    orders = {result["key"]: result["found"]["order"] for result in found["results"]}
    assert orders["z_peak"] == pytest.approx(2.0, abs=0.02)

    code, printed, _ = vm("converge", "VM-061")
    assert "converge VM-061: 3 runs, 3 of them from cache" in printed
    assert json.loads((here / "reports/VM-061/studies/converge.json").read_text()) == found
    vm("run", "VM-061")
    assert "## Convergence" in (here / "reports/VM-061/README.md").read_text()


def test_check_names_studies_that_other_sources_made(study, here, vm, monkeypatch):
    assert vm("converge", "VM-061")[0] == 0
    made = json.loads((here / "reports/VM-061/studies/converge.json").read_text())["made_by"]
    assert made == {"solver": f"vmharness {__version__}", "sources": sources()}
    assert "study converge" not in vm("check", "VM-061")[1]
    monkeypatch.setattr("vmharness.studies.sources.sources", lambda: "0123abcd" * 8)
    line = f"doubtful: study converge: made from sources {made['sources'][:8]}; the sources are now 0123abcd"
    assert line in vm("check", "VM-061")[1]


def test_a_promise_that_is_not_kept_fails(study, vm):
    change(study, ("z_peak = 2 }", "z_peak = 3 }"))
    code, printed, _ = vm("converge", "VM-061")
    assert code == 1
    assert "z_peak: the order is lower than theory expects" in printed


def test_sweep_says_where_the_worst_is(study, here, vm):
    code, printed, _ = vm("sweep", "VM-061", "-n", "3", "--seed", "4", "--json", "found.json")
    assert code == 0
    assert "3 points of a Latin hypercube, seed 4" in printed
    assert "All results are within their tolerances at 3 of 3 points." in printed
    found = json.loads((here / "found.json").read_text())
    assert len(found["data"]["m"]) == 3


def test_a_sweep_that_fails_ends_with_a_line_that_runs_the_simplest_such_point(study, vm):
    """A deck whose mass is right for the case's own data alone."""
    change(study, ('M      = "m"', 'M      = "sqrt(0.5*m)"'))
    assert vm("run", "VM-061", "--no-report")[0] == 0
    code, printed, _ = vm("sweep", "VM-061", "--cases", "cases", "-n", "2")
    assert code == 1
    (line,) = [line for line in printed.splitlines() if line.startswith("Out of tolerance: ")]
    again = line.partition("point that fails: vm ")[2].split()
    assert again[2:4] == ["--cases", "cases"]
    assert [word.partition("=")[0] for word in again if "=" in word] == ["m", "rho"]
    assert vm(*again, "--no-report")[0] == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ("converge", "VM-06*"),
        ("sweep", "VM-09"),
        ("sweep", "VM-061", "-n", "3", "--grid", "2"),
        ("sweep", "VM-061", "--seed", "-1"),
    ],
)
def test_usage(ball, vm, arguments):
    ball()
    ball("VM-062")
    assert vm(*arguments)[0] == 4


def test_a_case_without_a_plan_says_so(study, vm):
    text = (study / "case.toml").read_text()
    start, end = text.index("[converge]"), text.index("[sweep]")
    (study / "case.toml").write_text(text[:start] + text[end:])
    code, _, complaint = vm("converge", "VM-061")
    assert code == 4
    assert "VM-061: case.toml has no [converge] table" in complaint


def test_what_is_done_when_interrupted_is_taken_up_again(ball, vm_process):
    folder = ball()
    change(folder, (HALF[0], f"levels  = [45, 90, 4000000]  # {time.time_ns()}: never run before"))
    first, second, endless = [gather.kept_file(variant.key("builtin")) for variant in variants(read(folder))]
    process = vm_process("converge", "VM-061", "-j", "1")
    while not (first.exists() and second.exists()):
        assert process.poll() is None
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate()
    assert process.returncode == 2, out + err
    assert "2 of 3 runs are done and kept; repeat the command to continue" in err
    assert not endless.exists()
