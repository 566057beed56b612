"""Results as JUnit XML for continuous integration: one suite for each case, one test for each result."""

import re
from collections.abc import Sequence
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from vmharness.compare import Verdict
from vmharness.report.number import decimals, positional, significant
from vmharness.result import CaseRun, Row, Unrun

# Characters that XML 1.0 does not allow, even escaped.
_ILLEGAL = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def render(runs: Sequence[CaseRun], unrun: Sequence[Unrun]) -> str:
    """All runs as one document; a case without a run is a suite with one error."""
    suites = [*map(_suite, runs), *map(_unrun, unrun)]
    root = Element("testsuites", {"name": "vmharness", **_totals(suites)})
    root.extend(suites)
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def _suite(run: CaseRun) -> Element:
    suite = Element("testsuite", name=_legal(f"{run.case.id} {run.case.file.title}"))
    properties = SubElement(suite, "properties")
    for name, value in (
        ("solver", run.solution.solver),
        ("verdict", str(run.verdict)),
        ("cycles", str(run.solution.cycles)),
        ("deck.sha256", run.deck_sha256),
        ("case.sha256", run.case_sha256),
        *((f"{name}.sha256", sha256) for name, sha256 in run.included.items()),
    ):
        SubElement(properties, "property", name=name, value=_legal(value))
    tests = [_test(run, row) for row in run.rows]
    if run.solution.failure or not tests:
        reason = run.reason or "no result was judged"
        tests.append(_verdict(_named(run.case.id, "solver"), Verdict.ERROR, reason))
    return _counted(suite, tests, run.seconds)


def _unrun(case: Unrun) -> Element:
    test = _verdict(_named(case.id, "case"), Verdict.ERROR, case.reason)
    return _counted(Element("testsuite", name=_legal(case.id)), [test], 0.0)


def _counted(suite: Element, tests: list[Element], seconds: float) -> Element:
    """The suite with its tests and their counts."""
    suite.extend(tests)
    suite.attrib |= {
        "tests": str(len(tests)),
        "failures": str(sum(test.find("failure") is not None for test in tests)),
        "errors": str(sum(test.find("error") is not None for test in tests)),
        "skipped": "0",
        "time": f"{seconds:.3f}",
    }
    return suite


def _test(run: CaseRun, row: Row) -> Element:
    test = _verdict(_named(run.case.id, row.key), row.verdict, row.comparison.reason)
    comparison = row.comparison
    SubElement(test, "system-out").text = _legal(
        f"{row.event}, {row.label} ({row.unit}): target {significant(comparison.target)}, "
        f"value {significant(comparison.value)}, error {decimals(comparison.error_percent)} %, "
        f"tolerance {positional(comparison.tolerance_percent)} %"
    )
    return test


def _named(case: str, name: str) -> Element:
    return Element("testcase", classname=_legal(case), name=_legal(name), time="0")


def _verdict(test: Element, verdict: Verdict, reason: str) -> Element:
    if verdict is not Verdict.PASS:
        kind = "failure" if verdict is Verdict.FAIL else "error"
        SubElement(test, kind, type=str(verdict), message=_legal(reason)).text = _legal(reason)
    return test


def _totals(suites: list[Element]) -> dict[str, str]:
    counts = {
        name: str(sum(int(suite.attrib[name]) for suite in suites))
        for name in ("tests", "failures", "errors")
    }
    return {**counts, "time": f"{sum(float(suite.attrib['time']) for suite in suites):.3f}"}


def _legal(text: str) -> str:
    """The text with a question mark for each character that XML does not allow."""
    return _ILLEGAL.sub("?", text)
