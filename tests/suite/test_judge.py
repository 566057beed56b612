from pathlib import Path

from vmharness.case import read
from vmharness.compare import Verdict
from vmharness.execution.message import Began, Done, Lost, Raised
from vmharness.suite.judge import judged
from vmharness.suite.outcome import Outcome, Status

BALL = Path(__file__).parents[2] / "cases" / "VM-061"


class Replies:
    """A pool that answers each task with what it is told to."""

    def __init__(self, *messages):
        self.messages = messages

    def each(self, tasks, timeout):
        for number, message in enumerate(self.messages):
            yield number, Began()
            yield number, message


def outcomes(*messages):
    cases = [read(BALL)] * len(messages)
    return [
        event for _, event in judged(Replies(*messages), cases, "fake", 1.0) if isinstance(event, Outcome)
    ]


def test_a_lost_worker_is_a_run_that_could_not_be_judged_with_all_its_results():
    (lost,) = outcomes(Lost("killed by SIGSEGV"))
    assert (lost.status, lost.reason) == (Status.UNJUDGED, "killed by SIGSEGV")
    assert [row.key for row in lost.run.rows] == [result.key for result in read(BALL).file.results]
    assert {row.verdict for row in lost.run.rows} == {Verdict.ERROR}
    assert lost.share is None


def test_an_exception_in_a_worker_is_a_defect():
    (defect,) = outcomes(Raised("KeyError: 'x'", "the traceback"))
    assert defect == Outcome("VM-061", Status.DEFECT, "KeyError: 'x'", None, "the traceback")


def test_a_solution_that_cannot_be_judged_is_a_defect_of_that_case_alone():
    first, second = outcomes(Done("no solution at all"), Lost("crash"))
    assert first.status is Status.DEFECT
    assert "test_judge" not in first.reason
    assert "judge.py" in first.traceback
    assert second.status is Status.UNJUDGED
