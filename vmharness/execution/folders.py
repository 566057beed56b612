"""Work folders: one for each run, gone after it, unless the run failed and has left files to look at."""

import contextlib
import shutil
import tempfile
from pathlib import Path
from types import TracebackType


class WorkFolders:
    """The work folders of many runs, by number, below one temporary folder; a context manager.

    On leaving it, all are removed but those that `close` has kept.
    """

    def __init__(self) -> None:
        self._root = Path(tempfile.mkdtemp(prefix="vmharness-"))
        self._kept: set[Path] = set()

    def __enter__(self) -> "WorkFolders":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        for folder in set(self._root.iterdir()) - self._kept:
            shutil.rmtree(folder, ignore_errors=True)
        with contextlib.suppress(OSError):  # some are kept
            self._root.rmdir()

    def folder(self, number: int) -> Path:
        """The folder of a run, made here and empty."""
        path = self._root / str(number)
        path.mkdir()
        return path

    def close(self, number: int, failure: str = "") -> str:
        """Remove the folder of a run; if that failed and has left files, keep it and say where after `failure`."""
        path = self._root / str(number)
        if failure and any(path.iterdir()):
            self._kept.add(path)
            return f"{failure} (its files: {path})"
        shutil.rmtree(path, ignore_errors=True)
        return failure
