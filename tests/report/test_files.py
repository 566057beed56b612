"""Results for machines: JSON that its published schema describes, and JUnit that every reader accepts."""

import json
import time
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import junitparser
import pytest
from jsonschema import Draft202012Validator

from vmharness.case.settings import with_settings
from vmharness.compare import Verdict
from vmharness.report import formats, render
from vmharness.suite.export import exported
from vmharness.suite.outcome import Outcome, Status
from vmharness.suite.select import entry
from vmharness.suite.timed import Began

ROOT = Path(__file__).parents[2]
SCHEMA = json.loads((ROOT / "docs" / "schema" / "results.schema.json").read_text())
STATUSES = {
    Verdict.PASS: Status.PASS,
    Verdict.FAIL: Status.FAIL,
    Verdict.ERROR: Status.UNJUDGED,
    Verdict.UNREPRESENTABLE: Status.UNREPRESENTABLE,
}

# Attributes of the schema junit-10.xsd that Jenkins, GitLab and pytest follow, by element; "!" marks what must be there.
ALLOWED = {
    "testsuites": "name time tests failures disabled errors",
    "testsuite": "name! tests! failures errors group time skipped timestamp hostname id package file log url version",
    "properties": "",
    "property": "name! value!",
    "testcase": "name! assertions time timestamp classname! status class file line log group url",
    "failure": "type message",
    "error": "type message",
    "skipped": "type message",
    "system-out": "",
}
INSIDE = {
    "testsuites": {"testsuite"},
    "testsuite": {"properties", "testcase"},
    "properties": {"property"},
    "testcase": {"failure", "error", "skipped", "system-out"},
}


def outcome(run, **other):
    """The outcome of a run that took three seconds."""
    known = Outcome(
        run.case.id, STATUSES[run.verdict], run.reason, run, started="2026-01-31T09:30:00Z", seconds=3.0
    )
    return replace(known, **other)


def export(*outcomes, solver="builtin"):
    """A run of these outcomes; those without a run are of cases that are not there."""
    found = {one.run.case.folder for one in outcomes if one.run}
    began = Began(["vm", "run", "-j", "2"], "2026-01-31T09:29:58Z", time.perf_counter() - 7.0)
    return exported(outcomes, [entry(folder) for folder in found], solver, began)


def as_json(*outcomes, **options):
    """The JSON of a run, which the published schema describes."""
    text = render("json", export(*outcomes, **options))
    document = json.loads(text, parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))
    Draft202012Validator(SCHEMA).validate(document)
    return document


def as_junit(*outcomes):
    """The XML of a run, with nothing that readers do not know."""
    root = ElementTree.fromstring(render("junit", export(*outcomes)).encode("utf-8"))
    for element in root.iter():
        attributes = ALLOWED[element.tag].split()
        assert set(element.attrib) <= {name.removesuffix("!") for name in attributes}
        assert {name.removesuffix("!") for name in attributes if name.endswith("!")} <= set(element.attrib)
        assert {child.tag for child in element} <= INSIDE.get(element.tag, set())
    return root


def test_the_folder_is_the_list():
    assert formats() == ["json", "junit"]


def test_the_published_schema_is_up_to_date():
    """Write it anew with: python -m vmharness.export > docs/schema/results.schema.json"""
    from vmharness.export import json_schema

    Draft202012Validator.check_schema(SCHEMA)
    assert json_schema() == SCHEMA


def test_the_schema_refuses_a_result_without_a_verdict(good):
    document = as_json(outcome(good))
    del document["cases"][0]["results"][0]["verdict"]
    (wrong,) = Draft202012Validator(SCHEMA).iter_errors(document)
    assert "verdict" in wrong.message


def test_json_has_exactly_the_keys_of_the_contract(good):
    document = as_json(outcome(good))
    assert list(document) == [
        "schema", "version", "command", "started", "seconds", "machine", "solvers", "counts", "cases"
    ]  # fmt: skip
    assert document["schema"] == 2
    (case,) = document["cases"]
    assert list(case) == [
        "id", "title", "folder", "solver", "set", "outcome", "verdict", "reason", "started", "seconds", "cycles",
        "facts", "notes", "sha256", "inputs_sha256", "results",
    ]  # fmt: skip
    assert [result["key"] for result in case["results"]] == [
        "t_impact", "z_impact", "v_impact", "ke_impact", "t_peak", "z_peak"
    ]  # fmt: skip
    for result in case["results"]:
        assert list(result) == [
            "key", "label", "event", "channel", "unit", "target", "value", "error", "error_percent", "tolerance",
            "tolerance_percent", "share", "verdict", "reason", "published",
        ]  # fmt: skip
    peak = case["results"][-1]
    assert peak["published"] == {"LS-DYNA": -1.5505, "VM65": -1.5506}
    assert peak["target"] == good.rows[-1].comparison.target  # every digit
    assert peak["share"] == pytest.approx(0.5)
    assert peak["error"] == pytest.approx(0.5 * peak["tolerance"])


def test_json_says_who_ran_what_where_and_when(good):
    document = as_json(outcome(good))
    assert document["command"] == ["vm", "run", "-j", "2"]
    assert document["started"] == "2026-01-31T09:29:58Z"
    assert document["seconds"] >= 7.0
    assert document["machine"]["cores"] >= 1
    assert {"numpy", "numba"} <= set(document["machine"]["packages"])
    (solver,) = document["solvers"]
    assert (solver["name"], solver["version"].split()[0]) == ("builtin", "vmharness")
    (case,) = document["cases"]
    assert (case["started"], case["seconds"]) == ("2026-01-31T09:30:00Z", 3.0)
    assert case["sha256"] == {"case.toml": "c" * 64, "deck.k": "d" * 64}
    assert case["inputs_sha256"] == good.case.inputs_sha256


def test_json_says_null_and_never_nan(broken):
    document = as_json(outcome(broken))
    peak = document["cases"][0]["results"][-1]
    assert peak["value"] is None
    assert peak["error_percent"] is None
    assert peak["reason"]
    assert document["cases"][0]["verdict"] == "error"


def test_a_case_that_did_not_pass_has_its_reason(failed, broken):
    (case,) = as_json(outcome(failed))["cases"]
    assert (case["outcome"], case["verdict"]) == ("fail", "fail")
    assert case["reason"].startswith("z_peak: ")
    reasons = {result["key"]: result["reason"] for result in case["results"]}
    assert "differs from -1.550666" in reasons.pop("z_peak")
    assert set(reasons.values()) == {""}
    (case,) = as_json(outcome(broken))["cases"]
    assert (case["outcome"], case["verdict"]) == ("error", "error")
    assert case["reason"] == "energy is not finite at t = 0.08 <cycle 800>"


def test_cases_are_in_the_order_of_the_manual_whichever_ended_first(good):
    late = replace(good, case=replace(good.case, id="VM-2"))
    document = as_json(Outcome("VM-3", Status.NOT_RUN, "interrupted"), outcome(late), outcome(good))
    assert [case["id"] for case in document["cases"]] == ["VM-061", "VM-2", "VM-3"]
    assert document["counts"] == {"pass": 2, "not run": 1}


def test_other_data_are_named(good):
    (case,) = as_json(outcome(replace(good, case=with_settings(good.case, {"k": 2500.0}))))["cases"]
    assert case["set"] == {"k": 2500.0}


@pytest.mark.parametrize("status", [Status.BROKEN, Status.DEFECT, Status.NOT_RUN, Status.UNJUDGED])
def test_a_case_without_a_run_is_not_left_out(good, status):
    reason = "[given] k: no unit lbx"
    _, missing = as_json(outcome(good), Outcome("VM-2", status, reason))["cases"]
    assert missing["id"] == "VM-2"
    assert (missing["outcome"], missing["verdict"], missing["reason"]) == (status, "error", reason)
    assert missing["results"] == []
    assert missing["solver"].startswith("vmharness")  # that it was meant for
    assert missing["seconds"] is missing["cycles"] is missing["folder"] is None
    root = as_junit(outcome(good), Outcome("VM-2", status, reason))
    assert (root.get("tests"), root.get("failures"), root.get("errors")) == ("7", "0", "1")
    suite = root.find("testsuite[@name='VM-2']")
    assert (suite.get("tests"), suite.get("errors")) == ("1", "1")
    assert suite.find("testcase/error").get("message") == reason
    assert suite.find("testcase/error").get("type") == status


def test_a_case_that_the_solver_cannot_represent_is_skipped_and_no_failure(good):
    why = "no contact in this solver"
    rows = tuple(
        replace(row, comparison=replace(row.comparison, verdict=Verdict.UNREPRESENTABLE, reason=why))
        for row in good.rows
    )
    run = outcome(replace(good, rows=rows), status=Status.UNREPRESENTABLE, reason=why)
    (case,) = as_json(run)["cases"]
    assert (case["outcome"], case["verdict"], case["reason"]) == (
        "not representable",
        "not representable",
        why,
    )
    (suite,) = as_junit(run)
    assert (suite.get("tests"), suite.get("failures"), suite.get("errors"), suite.get("skipped")) == (
        "6",
        "0",
        "0",
        "6",
    )


def test_junit_counts_what_it_holds(good, failed, broken):
    ids = iter("abc")
    runs = [replace(run, case=replace(run.case, id=next(ids))) for run in (good, failed, broken)]
    root = as_junit(*map(outcome, runs))
    suites = root.findall("testsuite")
    assert [(s.get("tests"), s.get("failures"), s.get("errors")) for s in suites] == [
        ("6", "0", "0"),
        ("6", "1", "0"),
        ("7", "2", "1"),  # NaN fails two results; the solver itself is the error
    ]
    assert (root.get("tests"), root.get("failures"), root.get("errors")) == ("19", "3", "1")
    for suite in suites:
        cases = suite.findall("testcase")
        assert len(cases) == int(suite.get("tests"))
        assert sum(case.find("failure") is not None for case in cases) == int(suite.get("failures"))
    failure = suites[1].find("testcase[@name='z_peak']/failure")
    assert "differs from -1.550666" in failure.get("message")


def test_junit_says_where_when_and_how_long(good, tmp_path):
    path = tmp_path / "results.xml"
    path.write_text(render("junit", export(outcome(good))), encoding="utf-8")
    (suite,) = junitparser.JUnitXml.fromfile(str(path))
    assert (suite.tests, suite.failures, suite.errors) == (6, 0, 0)
    assert suite.timestamp == "2026-01-31T09:30:00"
    assert suite.hostname
    assert suite.time == 3.0
    assert sum(test.time for test in suite) == pytest.approx(3.0, abs=1e-4)
    for test in suite:
        assert test._elem.get("file").endswith("cases/VM-061/case.toml")
    assert {property.name: property.value for property in suite.properties()}["deck.k.sha256"] == "d" * 64


def test_a_failure_in_junit_says_value_target_error_and_tolerance(failed):
    test = as_junit(outcome(failed)).find(".//testcase[@name='z_peak']")
    message = test.find("failure").get("message")
    for part in ("value -1.55061909 in", "target -1.55066561 in", "error -0.003 %", "tolerance 0.001 %"):
        assert part in message


def test_junit_holds_no_character_that_xml_cannot(broken):
    run = replace(broken, solution=replace(broken.solution, failure='\x1b[31mred\x00 "<&>" \ud800'))
    error = as_junit(outcome(run)).find(".//testcase[@name='solver']/error")
    assert error.text == '?[31mred? "<&>" ?'


def test_a_solver_that_cannot_be_asked_has_its_name_alone(good):
    (solver,) = as_json(outcome(good), solver="nosuch")["solvers"]
    assert solver["version"] == "nosuch"
