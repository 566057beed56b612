"""A hash of files, by their names and contents."""

import hashlib
from collections.abc import Iterable
from pathlib import Path

PROSE = {".md", ".svg", ".png"}


def digest(folder: Path, paths: Iterable[Path]) -> str:
    """SHA-256 over the files at these `paths`, which count from `folder`, whatever their order."""
    found = hashlib.sha256()
    for path in sorted(paths):
        found.update(f"{path.as_posix()}\0".encode())
        found.update((folder / path).read_bytes())
    return found.hexdigest()


def inputs(folder: Path) -> str:
    """Of all files of a case's folder but prose and pictures, on which no result depends."""
    paths = (path.relative_to(folder) for path in folder.rglob("*") if path.is_file())
    return digest(folder, (path for path in paths if path.suffix not in PROSE))
