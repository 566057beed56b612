"""Whatever a case folder holds, reading ends soon, with a case or with a CaseError that names the place."""

import os
import re
import shutil
from pathlib import Path

import pytest

from vmharness.case import CaseError, read

BALL = Path(__file__).parents[2] / "cases" / "VM-061"
FIBONACCI = ["a0 = {formula = 'h'}", "a1 = 'a0'", *(f"a{i} = 'a{i - 1} - a{i - 2}'" for i in range(2, 90))]
CHAIN = ["a0 = {formula = 'h'}", *(f"a{i} = 'a{i - 1}'" for i in range(1, 3000))]
SUMS = ["a0 = 'sum(sum(sum(sum(1, i, 1, 100), j, 1, 100), k, 1, 100), n, 1, 100)'"]


@pytest.fixture
def ball(tmp_path):
    """A copy of VM-061, with text added at the beginning of its table [theory]."""

    def copy(*lines):
        folder = shutil.copytree(BALL, tmp_path / "ball")
        text = (folder / "case.toml").read_text()
        (folder / "case.toml").write_text(text.replace("[theory]", "\n".join(["[theory]", *lines]), 1))
        return folder

    return copy


@pytest.mark.parametrize("lines", [FIBONACCI, CHAIN])
def test_long_chains_of_theory_are_followed_once(ball, lines):
    case = read(ball(*lines))
    assert case.origins(lines[-1].partition(" ")[0]) == {"h"}


def test_a_sum_without_end_is_refused(ball):
    with pytest.raises(CaseError, match=r"\[theory\] a0: .* are too many"):
        read(ball(*SUMS))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"a = 1\nx = " + 20_000 * b"[" + 20_000 * b"]", r"ball/case.toml:2: nested too deeply"),
        (b"a = 1\nx = " + 5000 * b"9", r"ball/case.toml:2: a whole number of more than 4300 digits"),
        (b"a = 1\nx = '\xe9'", r"ball/case.toml:2: the byte 0xe9 is not UTF-8"),
        (b"a = 1\nx = '\0'", r"ball/case.toml: not TOML"),
        (b"#" * 2_000_000, r"ball/case.toml: longer than 1000000 bytes"),
        (b"x = 1\n" + 20_000 * b"a." + b"a = 1", r"ball/case.toml:2: a key of more than 100 parts"),
        (b"x = 1\n[" + 20_000 * b"'a b' . " + b"a]", r"ball/case.toml:2: a key of more than 100 parts"),
        (b"title = 1", r"ball/case.toml: \[title\]: Expected `str`, got `int`"),
    ],
)
def test_a_file_that_cannot_be_read(ball, content, message):
    folder = ball()
    (folder / "case.toml").write_bytes(content)
    with pytest.raises(CaseError, match=message):
        read(folder)


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ('files = ["a\\u0000b"]', r"files 1: 'a\\x00b' cannot be the name of a file"),
        (f'files = ["{5000 * "a"}"]', r"files 1: 'a+\.\.\.' cannot be the name of a file"),
        (f'files = ["{"a/" * 2500}"]', r"cannot be the name of a file"),
    ],
)
def test_a_name_that_no_file_can_have(ball, entry, message):
    folder = ball()
    text = (folder / "case.toml").read_text()
    (folder / "case.toml").write_text(re.sub("(?m)^files.*$", lambda _: entry, text))
    with pytest.raises(CaseError, match=message):
        read(folder)


def test_a_link_to_itself_and_prose_that_is_not_utf8(ball):
    folder = ball()
    (folder / "p.svg").symlink_to("p.svg")
    with pytest.raises(CaseError, match=r"ball/p.svg: a link that leads nowhere"):
        read(folder)
    (folder / "p.svg").unlink()
    (folder / "README.md").write_bytes(b"# ball\n\n## Caf\xe9\n")
    with pytest.raises(CaseError, match=r"ball/README.md:3: the byte 0xe9 is not UTF-8"):
        read(folder)


def test_a_pipe_in_place_of_the_file(ball):
    folder = ball()
    (folder / "case.toml").unlink()
    os.mkfifo(folder / "case.toml")
    with pytest.raises(CaseError, match=r"ball/case\.toml: not a file"):
        read(folder)
