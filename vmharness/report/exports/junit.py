"""Results as JUnit XML for continuous integration: one suite for each case, one test for each result.

Elements, attributes and their order are those of the schema junit-10.xsd, which Jenkins, GitLab and pytest use.
"""

import re
from collections.abc import Mapping
from pathlib import PurePath
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from vmharness.export import Case, Result, Run

# Characters that XML 1.0 does not allow, even escaped.
_ILLEGAL = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
FILE = "case.toml"
# Of verdicts; every other one is an error.
KINDS = {"fail": "failure", "not reported": "skipped", "not representable": "skipped"}


def render(run: Run) -> str:
    """All cases as one document; in a case of which nothing was judged one test has the error."""
    suites = [_suite(number, case, run) for number, case in enumerate(run.cases)]
    totals = {
        name: str(sum(int(suite.attrib[name]) for suite in suites))
        for name in ("tests", "failures", "errors")
    }
    root = _element("testsuites", {"name": "vmharness", **totals, "time": f"{run.seconds:.3f}"})
    root.extend(suites)
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def _suite(number: int, case: Case, run: Run) -> Element:
    tests = _tests(case)
    for test in tests:  # the results come from one run: each has an equal part of its time
        test.set("time", f"{(case.seconds or 0.0) / len(tests):.6f}")
    suite = _element(
        "testsuite",
        {
            "name": f"{case.id} {case.title}".strip(),
            "tests": str(len(tests)),
            "failures": str(sum(test.find("failure") is not None for test in tests)),
            "errors": str(sum(test.find("error") is not None for test in tests)),
            "skipped": str(sum(test.find("skipped") is not None for test in tests)),
            "time": f"{case.seconds or 0.0:.6f}",
            "timestamp": (case.started or run.started).removesuffix("Z"),  # the schema has no zone: it is UTC
            "hostname": run.machine.host,
            "id": str(number),
            "package": "vmharness",
            **_file(case),
        },
    )
    properties = SubElement(suite, "properties")
    for name, value in _properties(case).items():
        properties.append(_element("property", {"name": name, "value": value}))
    suite.extend(tests)
    return suite


def _properties(case: Case) -> dict[str, str]:
    return {
        "solver": case.solver,
        "outcome": case.outcome,
        **({"reason": case.reason} if case.reason else {}),
        **({"cycles": str(case.cycles)} if case.cycles is not None else {}),
        **{f"set.{name}": f"{value!r}" for name, value in case.set.items()},
        **{f"{name}.sha256": digest for name, digest in case.sha256.items()},
    }


def _tests(case: Case) -> list[Element]:
    """A test for each result; one with the reason where these do not say why the case has its outcome."""
    tests = [_test(case, result) for result in case.results]
    said = any(result.verdict == case.verdict for result in case.results)
    if not said or case.outcome != case.verdict or case.outcome == "error":
        test = _named(case, "solver" if case.results else "case")
        kind = KINDS.get(case.verdict, "error")
        test.append(_reason(kind, case.outcome, case.reason or "no result was judged"))
        tests.append(test)
    return tests


def _test(case: Case, result: Result) -> Element:
    test, line = _named(case, result.key), _line(result)
    if result.verdict != "pass":
        kind = KINDS.get(result.verdict, "error")
        test.append(_reason(kind, result.verdict, f"{result.reason}; {line}" if result.reason else line))
    SubElement(test, "system-out").text = _legal(line)
    return test


def _line(result: Result) -> str:
    """The result in a line: value, target, error and tolerance, with the digits that tell them apart."""
    unit = f" {result.unit}" if result.unit else ""
    value = "none" if result.value is None else f"{result.value:.9g}{unit}"
    line = f"{result.event}, {result.label}: value {value}, target {result.target:.9g}{unit}"
    if result.error_percent is not None:
        line += f", error {result.error_percent:+.3g} %"
    if result.tolerance_percent is not None:
        return f"{line}, tolerance {result.tolerance_percent:.3g} %"
    return f"{line}, tolerance {result.tolerance:.3g}{unit}"


def _reason(kind: str, outcome: str, reason: str) -> Element:
    found = _element(kind, {"type": outcome, "message": reason})
    found.text = _legal(reason)
    return found


def _named(case: Case, name: str) -> Element:
    return _element("testcase", {"classname": case.id, "name": name, **_file(case)})


def _file(case: Case) -> dict[str, str]:
    return {} if case.folder is None else {"file": PurePath(case.folder, FILE).as_posix()}


def _element(name: str, attributes: Mapping[str, str]) -> Element:
    return Element(name, {key: _legal(value) for key, value in attributes.items()})


def _legal(text: str) -> str:
    """The text with a question mark for each character that XML does not allow."""
    return _ILLEGAL.sub("?", text)
