import re
import shutil
from pathlib import Path

import pytest

from vmharness.suite.check import check

BALL = Path(__file__).parents[2] / "cases" / "VM-061"


@pytest.fixture
def changed(tmp_path):
    """Makes a copy of the case with text of one of its files replaced, and checks that."""

    def check_changed(file, pattern, replacement):
        folder = tmp_path / "VM-061"
        shutil.copytree(BALL, folder)
        text, found = re.subn(pattern, replacement, (folder / file).read_text(), count=1)
        assert found
        (folder / file).write_text(text)
        return check(folder)

    return check_changed


def test_the_case_of_the_manual_is_sound():
    review = check(BALL)
    assert (review.wrong, review.doubtful) == ([], [])


@pytest.mark.parametrize(
    ("file", "pattern", "replacement", "message"),
    [
        ("case.toml", "(?m)^title", "titel", r"VM-061/case.toml: .*titel"),
        ("case.toml", r"sqrt\(k/m\)", "sqrt(k/m", r"\[theory\] omega"),
        ("case.toml", r"g\*t_impact", "g*k", r"unit"),
        ("deck.k", r"\*MAT_ELASTIC", "*MAT_ELASTICK", r"deck.k:\d+: \*MAT_ELASTICK.*MAT_ELASTIC"),
        ("deck.k", r"(?m)^       2       5    ", "       2       6    ", r"deck.k:\d+.*no \*NODE 6"),
        ("case.toml", r"(?m)^z +=.*?5", "z = { node = 7", r"\[channels\] z: no node 7 in the deck"),
        ("case.toml", "contact = 1,", "contact = 2,", r"\[channels\] contact_force: no contact 2; there are: 1"),
        ("case.toml", 'energy = "kinetic"', 'energy = "kinetik"', r"\[channels\] kinetic: no 'kinetik'"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_found_without_a_run(changed, file, pattern, replacement, message):
    review = changed(file, pattern, replacement)
    assert any(re.search(message, sentence) for sentence in review.wrong), review.wrong
