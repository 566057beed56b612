import itertools

import pytest

from vmharness.suite.outcome import EXIT_CODES, Outcome, Status, exit_code, worst_first


def test_each_status_alone():
    codes = {
        Status.PASS: 0,
        Status.FAIL: 1,
        Status.NOT_RUN: 2,
        Status.DEFECT: 3,
        Status.BROKEN: 4,
        Status.UNWRITTEN: 4,
        Status.UNJUDGED: 6,
        Status.UNREPRESENTABLE: 6,
    }
    assert codes == EXIT_CODES
    for status, code in codes.items():
        assert exit_code([status]) == code
    assert exit_code([]) == 5


@pytest.mark.parametrize("pair", list(itertools.combinations([2, 3, 4, 6, 1, 0], 2)))
def test_of_two_the_worse_counts_in_any_order(pair):
    by_code = {code: status for status, code in EXIT_CODES.items() if status is not Status.UNREPRESENTABLE}
    for statuses in itertools.permutations([by_code[code] for code in pair]):
        assert exit_code(statuses) == pair[0]


def test_what_cannot_be_represented_counts_only_alone():
    for status, code in EXIT_CODES.items():
        assert exit_code([Status.UNREPRESENTABLE, status]) == code


def test_worst_news_first():
    outcomes = [
        Outcome("b", Status.PASS),
        Outcome("a", Status.PASS),
        Outcome("c", Status.FAIL),
        Outcome("d", Status.DEFECT),
    ]
    assert [outcome.id for outcome in worst_first(outcomes)] == ["d", "c", "a", "b"]
