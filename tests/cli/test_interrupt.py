import json
import os
import signal
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator

SCHEMA = Path(__file__).parents[2] / "docs" / "schema" / "results.schema.json"


def workers_of(process):
    """Ids of the worker processes that `process` started."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    return [pid for pid in children if "spawn_main" in Path(f"/proc/{pid}/cmdline").read_text()]


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="reads /proc")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_ctrl_c_keeps_what_is_done_and_ends_every_worker(ball, vm_process, name):
    ball(id="done")
    ball(id="endless", density="7.3E-16")
    ball(id="never")
    process = vm_process("run", "done", "endless", "never", "--json", "r.json")
    while not (line := process.stdout.readline()).startswith("done: pass"):
        assert line, process.stderr.read()
    workers = workers_of(process)
    assert workers
    if name == "SIGINT":
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to the workers, too
    else:
        process.send_signal(signal.SIGTERM)
    out, err = process.communicate()
    assert process.returncode == 2
    assert "interrupted; finished cases are kept" in err
    assert "Traceback" not in out + err
    assert "2 not run, 1 pass" in out
    results = json.loads(Path("r.json").read_text())
    Draft202012Validator(json.loads(SCHEMA.read_text())).validate(results)
    assert [case["id"] for case in results["cases"]] == ["done", "endless", "never"]
    assert results["command"] == ["vm", "run", "done", "endless", "never", "--json", "r.json"]
    assert [case["outcome"] for case in results["cases"]] == ["pass", "not run", "not run"]
    assert all("interrupted" in case["reason"] for case in results["cases"][1:])
    assert Path("reports/done/index.html").is_file()
    last = json.loads(Path("reports/.last-run.json").read_text())
    statuses = {id: kept["status"] for id, kept in last.items()}
    assert statuses == {"done": "pass", "endless": "not run", "never": "not run"}
    for worker in workers:
        assert not Path(f"/proc/{worker}").exists()


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="reads /proc")
def test_a_killed_run_is_resumed_by_lf(ball, vm_process, vm):
    ball(id="done")
    ball(id="endless", density="7.3E-16")
    process = vm_process("run", "done", "endless", "--no-report")
    while not (line := process.stdout.readline()).startswith("done: pass"):
        assert line, process.stderr.read()
    process.kill()
    process.wait()
    last = json.loads(Path("reports/.last-run.json").read_text())
    assert {id: kept["status"] for id, kept in last.items()} == {"done": "pass", "endless": "not run"}
    code, out, _ = vm("run", "--lf", "--timeout", "1", "--no-report")
    assert code == 6
    assert "1 error" in out
    assert "endless" in out
