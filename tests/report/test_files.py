"""Results for machines: the JSON contract, and JUnit that every reader accepts."""

import json
from dataclasses import replace
from xml.etree import ElementTree

from vmharness.report import formats, render
from vmharness.result import Unrun


def test_the_folder_is_the_list():
    assert formats() == ["json", "junit"]


def test_json_has_exactly_the_keys_of_the_contract(good):
    document = json.loads(render("json", [good]))
    assert list(document) == ["schema", "version", "cases"]
    assert document["schema"] == 1
    (case,) = document["cases"]
    assert list(case) == ["id", "title", "solver", "verdict", "seconds", "cycles", "results"]
    assert [result["key"] for result in case["results"]] == [
        "t_impact", "z_impact", "v_impact", "ke_impact", "t_peak", "z_peak"
    ]  # fmt: skip
    for result in case["results"]:
        assert list(result) == [
            "key", "label", "event", "unit", "target", "value", "error_percent", "tolerance_percent",
            "verdict", "published",
        ]  # fmt: skip
    peak = case["results"][-1]
    assert peak["published"] == {"LS-DYNA": -1.5505, "VM65": -1.5506}
    assert peak["target"] == good.rows[-1].comparison.target  # every digit


def test_json_says_null_and_never_nan(broken):
    text = render("json", [broken])
    document = json.loads(text, parse_constant=lambda word: (_ for _ in ()).throw(AssertionError(word)))
    peak = document["cases"][0]["results"][-1]
    assert peak["value"] is None
    assert peak["error_percent"] is None
    assert document["cases"][0]["verdict"] == "error"


def test_junit_counts_what_it_holds(good, failed, broken):
    root = ElementTree.fromstring(render("junit", [good, failed, broken]))
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


def test_junit_holds_no_character_that_xml_cannot(broken):
    run = replace(broken, solution=replace(broken.solution, failure='\x1b[31mred\x00 "<&>" \ud800'))
    root = ElementTree.fromstring(render("junit", [run]).encode("utf-8"))
    error = root.find(".//testcase[@name='solver']/error")
    assert error.text == '?[31mred? "<&>" ?'


def test_a_case_without_a_run_is_not_left_out(good):
    unrun = [Unrun("VM-2", "[given] k: no unit lbx")]
    _, missing = json.loads(render("json", [good], unrun))["cases"]
    assert missing == {
        "id": "VM-2", "title": "", "solver": None, "verdict": "error", "seconds": None, "cycles": None,
        "results": [], "reason": "[given] k: no unit lbx",
    }  # fmt: skip
    root = ElementTree.fromstring(render("junit", [good], unrun))
    assert (root.get("tests"), root.get("failures"), root.get("errors")) == ("7", "0", "1")
    suite = root.find("testsuite[@name='VM-2']")
    assert (suite.get("tests"), suite.get("errors")) == ("1", "1")
    assert suite.find("testcase/error").get("message") == "[given] k: no unit lbx"
