"""A new case folder to fill in."""

from pathlib import Path

from vmharness.case.error import CaseError

BLANK = Path(__file__).parent / "blank"


def new(folder: Path) -> list[Path]:
    """Write case.toml, deck.k and README.md of an example; title, reference and reasons are empty.

    The id of the case is the name of the folder. Raises CaseError if the folder exists, OSError if it cannot be made.
    """
    if folder.exists():
        raise CaseError(f"{folder} exists already")
    folder.mkdir(parents=True)
    written = []
    for blank in sorted(BLANK.iterdir()):
        path = folder / blank.name
        path.write_text(blank.read_text(encoding="utf-8").replace("ID:", f"{folder.name}:"), encoding="utf-8")
        written.append(path)
    return written
