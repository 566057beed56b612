"""Hash of files by their names and contents."""

import hashlib
from collections.abc import Iterable
from pathlib import Path

PROSE = {".md", ".svg", ".png"}


def digest(folder: Path, paths: Iterable[Path]) -> str:
    """SHA-256 of the files at `paths` below `folder`, independent of their order."""
    found = hashlib.sha256()
    for path in sorted(paths):
        found.update(f"{path.as_posix()}\0".encode())
        found.update((folder / path).read_bytes())
    return found.hexdigest()


def inputs(folder: Path) -> str:
    """Hash of all files of a case folder except prose and pictures, on which no result depends."""
    paths = (path.relative_to(folder) for path in folder.rglob("*") if path.is_file())
    return digest(folder, (path for path in paths if path.suffix not in PROSE))
