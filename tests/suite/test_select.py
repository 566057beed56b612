import os
from pathlib import Path

import pytest

from vmharness.suite.select import Entry, SelectError, cases_folder, entries, matches, select


@pytest.fixture
def folder(tmp_path):
    """Five case folders, one of them broken, and one folder that is none."""
    cases = tmp_path / "cases"
    for id, title, tags in (
        ("VM-001", "Ball on a surface", ["contact", "impact"]),
        ("VM-002", "Beam under a load", ["beam"]),
        ("VM-010", "Plate that vibrates", ["shell", "modal"]),
        ("VM-100", "Ball in a pipe", ["contact", "shell"]),
    ):
        (cases / id).mkdir(parents=True)
        (cases / id / "case.toml").write_text(f"title = {title!r}\ntags = {tags!r}\n")
    (cases / "broken").mkdir()
    (cases / "broken" / "case.toml").write_text("title = \n")
    (cases / "notes").mkdir()
    return cases


def ids(folder, *selectors, **options):
    found, unknown = select(folder, selectors, **options)
    assert not unknown
    return [case.id for case in found]


def test_a_case_is_a_folder_with_a_case_file(folder):
    assert [case.id for case in entries(folder)] == ["VM-001", "VM-002", "VM-010", "VM-100", "broken"]
    assert ids(folder) == ["VM-001", "VM-002", "VM-010", "VM-100", "broken"]


def test_by_id_pattern_and_path_each_once(folder):
    assert ids(folder, "VM-010") == ["VM-010"]
    assert ids(folder, "VM-0*") == ["VM-001", "VM-002", "VM-010"]
    assert ids(folder, "VM-00?", "VM-002", "VM-1*") == ["VM-001", "VM-002", "VM-100"]
    assert ids(folder, str(folder / "VM-010")) == ["VM-010"]
    assert ids(folder, str(folder / "VM-010"), "VM-010") == ["VM-010"]


def test_a_path_outside_the_folder(folder, tmp_path):
    elsewhere = tmp_path / "mine"
    elsewhere.mkdir()
    (elsewhere / "case.toml").write_text('title = "Mine"')
    found, _ = select(folder, [str(elsewhere)])
    assert found == [Entry(elsewhere, "Mine")]


def test_two_cases_of_one_name_are_refused(folder, tmp_path):
    twin = tmp_path / "other" / "VM-001"
    twin.mkdir(parents=True)
    (twin / "case.toml").write_text('title = "Twin"')
    with pytest.raises(SelectError, match=r"two cases are called VM-001: .*VM-001 and .*other/VM-001"):
        select(folder, ["VM-001", str(twin)])


def test_tags_narrow(folder):
    assert ids(folder, tags=["contact"]) == ["VM-001", "VM-100"]
    assert ids(folder, tags=["contact", "shell"]) == ["VM-100"]
    assert ids(folder, tags=["cont"]) == []


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("ball", ["VM-001", "VM-100"]),
        ("BALL and not impact", ["VM-100"]),
        ("beam or modal", ["VM-002", "VM-010"]),
        ("not ball and not beam", ["VM-010", "broken"]),
        ("vm-01", ["VM-010"]),
        ("on a surface", ["VM-001"]),
        ("not shell and contact or modal", ["VM-001", "VM-010"]),
        (" ", ["VM-001", "VM-002", "VM-010", "VM-100", "broken"]),
    ],
)
def test_words(folder, words, expected):
    assert ids(folder, words=words) == expected


@pytest.mark.parametrize(
    "words", ["and", "ball and", "or ball", "not", "ball or not", "ball not beam", "not not ball"]
)
def test_words_that_mean_nothing(words):
    with pytest.raises(SelectError, match="write words with and, or, not"):
        matches(words, Entry(Path("VM-001"), "ball"))


def test_what_is_not_there_is_said_and_the_rest_selected(folder):
    found, unknown = select(folder, ["VM-002", "vm-01", "X*"])
    assert [case.id for case in found] == ["VM-002"]
    assert unknown["vm-01"].startswith("no case vm-01; did you mean VM-0")
    assert unknown["X*"] == "no case X*; `vm list` shows those that there are"


def test_the_folder_chosen_then_the_one_here_then_that_of_the_package(folder, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert cases_folder(folder / "VM-001") == folder / "VM-001"
    assert cases_folder() == Path("cases")
    (tmp_path / "empty" / "cases").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "empty")  # such as an empty submodule: other cases in its place would pass
    assert cases_folder() == Path("cases")
    (tmp_path / "none").mkdir()
    monkeypatch.chdir(tmp_path / "none")
    assert (cases_folder() / "VM-061" / "case.toml").is_file()
    with pytest.raises(SelectError, match="no folder nowhere"):
        cases_folder(Path("nowhere"))


@pytest.mark.parametrize(
    "content", [20_000 * b"a." + b"a = 1", b"x = " + 20_000 * b"[", b"#" * 2_000_000, b"\xff", None]
)
def test_a_file_that_cannot_be_parsed_in_bounded_time_has_no_title(tmp_path, content):
    (tmp_path / "a").mkdir()
    if content is None:
        os.mkfifo(tmp_path / "a" / "case.toml")
    else:
        (tmp_path / "a" / "case.toml").write_bytes(content)
    assert entries(tmp_path) == [Entry(tmp_path / "a")]
