"""Prose of a case: its README.md and the drawings beside it, which must lie in the folder of the case."""

from pathlib import Path

from vmharness.case.decode import utf8
from vmharness.case.error import CaseError

FILE = "README.md"


def read_prose(folder: Path) -> str:
    """The text of README.md, empty without such a file; raises CaseError if it cannot be read."""
    path = folder / FILE
    try:
        return utf8(path.read_bytes(), f"{folder.name}/{FILE}") if path.is_file() else ""
    except OSError as error:
        raise CaseError(f"{folder.name}/{FILE}: cannot be read: {error.strerror or error}") from None


def check_prose(folder: Path) -> None:
    """Raise CaseError for prose that cannot be read, and for links by which a page would copy files from elsewhere."""
    for path in (folder / FILE, *sorted(folder.glob("*.svg"))):
        if path.is_symlink():
            _check_link(path)
    read_prose(folder)


def _check_link(path: Path) -> None:
    place = f"{path.parent.name}/{path.name}"
    try:
        to = path.resolve(strict=True)
    except (OSError, RuntimeError):  # a loop is the one or the other, by the version of Python
        raise CaseError(f"{place}: a link that leads nowhere") from None
    if not to.is_relative_to(path.parent.resolve()):
        why = "is a link that leads out of the case's folder; put the file itself there"
        raise CaseError(f"{place}: {why}")
