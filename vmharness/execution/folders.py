"""Work folders: one for each run, removed after it; kept if the run failed and left files."""

import contextlib
import shutil
import tempfile
from pathlib import Path
from types import TracebackType


class WorkFolders:
    """The work folders of many runs, by number, in one temporary folder; a context manager.

    At its end, all are removed except those that `close` has kept.
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
        """Make the empty folder of a run."""
        path = self._root / str(number)
        path.mkdir()
        return path

    def close(self, number: int, failure: str = "") -> str:
        """Remove the folder of a run, or keep it if the run failed and left files.

        Returns `failure`, with the path of a folder that is kept.
        """
        path = self._root / str(number)
        if failure and any(path.iterdir()):
            self._kept.add(path)
            return f"{failure} (its files: {path})"
        shutil.rmtree(path, ignore_errors=True)
        return failure
