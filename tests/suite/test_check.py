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
        ("case.toml", "contact = 1,", "wall = 1,", r"\[channels\] contact_force: no rigid wall 1; there are: none"),
        ("case.toml", r'must_fail = \["t_peak", "z_peak"\]', 'must_fail = ["t_impact", "z_peak"]',
         r"\[faults\] 1 \(Surface 1 % too stiff\): t_impact must fail, but by theory it changes by only 0 of its tolerance"),
        ("case.toml", r'h = "\+0.1 %"', 'h = "+0.00001 %"',
         r"\[faults\] 4 .*: z_impact must fail, but by theory it changes by only 0\.1 of its tolerance"),
        ("case.toml", r'change    = \{ m = "\+1 %" \}', 'change = { dt = "+1 %" }', r"\[faults\] 3 .*nothing in the deck"),
        ("case.toml", r"(?m)^TEND ", "TENT ", r"deck.k: no parameter tent to set; did you mean tend"),
        ("case.toml", r"(?m)^TEND .*", 'A = "L/2"', r"A.* follows from other parameters"),
        ("README.md", r"schematic\.svg", "missing.svg", r"README.md: missing.svg: no drawing"),
        ("README.md", r"schematic\.svg", "../VM-061/schematic.svg", r"README.md: \.\./VM-061/schematic.svg: no drawing"),
        ("README.md", r"schematic\.svg", "https://example.org/a.svg", r"README.md: https://example.org/a.svg: no drawing"),
        ("case.toml", 'energy = "kinetic"', 'energy = "kinetik"', r"\[channels\] kinetic: no 'kinetik'"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_found_without_a_run(changed, file, pattern, replacement, message):
    review = changed(file, pattern, replacement)
    assert any(re.search(message, sentence) for sentence in review.wrong), review.wrong


def test_a_case_without_prose_is_wrong(tmp_path):
    folder = shutil.copytree(BALL, tmp_path / "VM-061")
    (folder / "README.md").unlink()
    assert check(folder).wrong == ["README.md: there is no such file in the case's folder"]
