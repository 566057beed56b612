import json


def test_two_runs_of_one_case(ball, vm, here):
    ball()
    assert vm("run", "VM-061", "--no-report", "--json", "a.json")[0] == 0
    text = (here / "cases" / "VM-061" / "deck.k").read_text()
    (here / "cases" / "VM-061" / "deck.k").write_text(
        text.replace("RM              0.5", "RM             0.51")
    )
    assert vm("run", "VM-061", "--no-report", "--json", "b.json")[0] == 1

    code, printed, _ = vm("compare", "a.json", "a.json")
    assert code == 0
    assert "6 results are equal, 0 are shown" in printed
    code, printed, complaint = vm("compare", "a.json", "b.json", "--json", "c.json")
    assert code == 1
    assert "ke_impact (lbf-in)" in printed
    assert "pass -> fail" in printed
    assert "VM-061 z_peak: pass in A, fail in B" in complaint
    pairs = {pair["key"]: pair for pair in json.loads((here / "c.json").read_text())}
    assert abs(pairs["ke_impact"]["percent"] - 2.0) < 0.01
    assert vm("compare", "b.json", "a.json")[0] == 0


def test_a_file_that_is_no_run(here, vm):
    (here / "a.json").write_text("[]")
    code, _, complaint = vm("compare", "a.json", "a.json")
    assert code == 4
    assert "not a file of `vm run --json`" in complaint


def test_a_run_of_another_schema_is_refused(here, vm):
    (here / "a.json").write_text('{"schema": 99, "version": "9", "cases": []}')
    code, _, complaint = vm("compare", "a.json", "a.json")
    assert code == 4
    assert "a.json: schema 99, but only 2 can be read" in complaint
