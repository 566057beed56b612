from types import SimpleNamespace

import pytest

from vmharness.compare import Tolerance, Verdict, compare
from vmharness.suite import last_run
from vmharness.suite.outcome import Outcome, Status


def test_what_did_not_pass_is_kept_until_it_does(tmp_path):
    last_run.write(
        tmp_path, [Outcome("a", Status.PASS), Outcome("b", Status.FAIL), Outcome("c", Status.NOT_RUN)]
    )
    assert last_run.not_passed(tmp_path) == {"b", "c"}
    last_run.write(tmp_path, [Outcome("b", Status.PASS)])
    assert last_run.not_passed(tmp_path) == {"c"}


def test_no_file_or_a_damaged_one_is_no_last_run(tmp_path):
    assert last_run.not_passed(tmp_path) == set()
    for text in ("", "[1]", "{", '{"a": "fail"}'):
        (tmp_path / last_run.FILE).write_text(text)
        assert last_run.not_passed(tmp_path) == set()


def test_errors_are_kept_as_fractions_of_the_targets(tmp_path):
    rows = [
        SimpleNamespace(
            key="x", comparison=compare(2.0, 2.02, Tolerance(relative=0.1)), verdict=Verdict.PASS
        ),
        SimpleNamespace(
            key="zero", comparison=compare(0.0, 0.1, Tolerance(absolute=1.0)), verdict=Verdict.PASS
        ),
    ]
    last_run.write(
        tmp_path, [Outcome("a", Status.PASS, run=SimpleNamespace(rows=rows)), Outcome("b", Status.FAIL)]
    )
    assert last_run.errors(tmp_path) == {"a": {"x": pytest.approx(0.01)}, "b": {}}


@pytest.mark.parametrize(
    "content",
    [
        "{}",
        "[]",
        "7",
        "[" * 99_999,
        '{"VM-061": 7}',
        '{"VM-061": {"errors": []}}',
        '{"VM-061": {"status": 1, "errors": [1]}}',
    ],
)
def test_a_file_that_is_no_record_has_no_errors_and_is_written_anew(tmp_path, content):
    (tmp_path / last_run.FILE).write_text(content)
    assert not any(last_run.errors(tmp_path).values())
    last_run.write(tmp_path, [Outcome("VM-061", Status.PASS)])
    assert last_run.read(tmp_path) == {"VM-061": "pass"}
