"""A file is the old one or the new one, never a part, and nothing is left beside it."""

import os

import pytest

from vmharness.execution import atomic
from vmharness.report import write_case


def test_writes_and_makes_the_folder(tmp_path):
    path = atomic.write(tmp_path / "new" / "page.md", "ω\n")
    assert path.read_bytes() == "ω\n".encode()
    assert [entry.name for entry in path.parent.iterdir()] == ["page.md"]


def test_what_goes_wrong_leaves_the_old_file_alone(tmp_path, monkeypatch):
    path = atomic.write(tmp_path / "page.md", "old")

    def full(*_):
        raise OSError("disk full")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(OSError, match="disk full"):
        atomic.write(path, "new")
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["page.md"]


def test_a_page_that_cannot_be_rendered_leaves_the_old_pages_alone(good, tmp_path, monkeypatch):
    write_case(good, tmp_path)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}

    def broken(*_):
        raise ValueError("no such filter")

    monkeypatch.setattr("vmharness.report.formats.markdown.case", broken)
    with pytest.raises(ValueError, match="no such filter"):
        write_case(good, tmp_path, volatile=False)
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before
