"""Prose of a case: files that are not text, and links that lead out of the folder."""

import re
import shutil
from pathlib import Path

import pytest

from vmharness.case import CaseError, read
from vmharness.case.prose import FILE, check_prose, read_prose

CASE = Path(__file__).parents[2] / "cases" / "VM-061"
OUT = "is a link that leads out of the case's folder; put the file itself there"


@pytest.fixture
def folder(tmp_path):
    return Path(shutil.copytree(CASE, tmp_path / "VM-061"))


def linked(path, to):
    path.unlink(missing_ok=True)
    path.symlink_to(to)


@pytest.mark.parametrize("name", [FILE, "schematic.svg", "p.svg"])
@pytest.mark.parametrize("to", ["../outside", "/etc/hostname"])
def test_a_link_to_a_file_elsewhere_is_refused(folder, name, to):
    (folder.parent / "outside").write_text("secret")
    linked(folder / name, to)
    with pytest.raises(CaseError, match=re.escape(f"VM-061/{name}: {OUT}")):
        read(folder)


def test_a_link_within_the_folder_is_allowed(folder):
    linked(folder / "p.svg", "schematic.svg")
    assert read(folder).id == "VM-061"


@pytest.mark.parametrize("to", ["p.svg", "missing.svg"])
def test_a_link_that_leads_nowhere_is_refused(folder, to):
    linked(folder / "p.svg", to)
    with pytest.raises(CaseError, match=r"VM-061/p\.svg: a link that leads nowhere"):
        read(folder)


def test_prose_of_another_encoding_is_refused_with_its_line(folder):
    (folder / FILE).write_bytes("# Prose\n\n## Overview\n\nEine Kugel fällt.\n".encode("latin-1"))
    with pytest.raises(
        CaseError, match=rf"VM-061/{FILE}:5: the byte 0xe4 is not UTF-8; save the file as UTF-8"
    ):
        read(folder)


def test_a_case_may_have_no_prose(tmp_path):
    check_prose(tmp_path)
    assert read_prose(tmp_path) == ""
