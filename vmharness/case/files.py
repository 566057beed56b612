"""The files of a case folder, as far as they can be wrong before any of them is used."""

from pathlib import Path

from vmharness.case.decode import FILE, utf8
from vmharness.case.error import CaseError
from vmharness.case.format import CaseFile

LONGEST = 255  # bytes of a file name
SHOWN = 40  # characters of a wrong one
TEXTS = {".md", ".svg"}  # files of the page


def check_files(folder: Path, file: CaseFile) -> None:
    """Raise CaseError for a name that no file can have, a link that leads nowhere, and a text that is not UTF-8."""
    named = [("[deck]: file", file.deck.file)]
    named += [(f"files {number}", name) for number, name in enumerate(file.files, 1)]
    for place, name in named:
        if "\0" in name or len(name.encode()) > LONGEST:
            shown = repr(name if len(name) <= SHOWN else f"{name[:SHOWN]}...")
            raise CaseError(f"{folder.name}/{FILE}: {place}: {shown} cannot be the name of a file")
    for path in sorted(folder.iterdir()):
        place = f"{folder.name}/{path.name}"
        if path.is_symlink() and not path.exists():
            raise CaseError(f"{place}: a link that leads nowhere")
        if path.suffix in TEXTS and path.is_file():
            utf8(path.read_bytes(), place)
