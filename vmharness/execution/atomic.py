"""Write a file so that a reader finds the old content or the new, and never a part."""

import os
import stat
import tempfile
from pathlib import Path

NEW = 0o644  # mode of a new file; the file of `mkstemp` can be read by its owner only


def write(path: Path, text: str) -> Path:
    """Write `text` as UTF-8 beside `path`, then put it in its place; makes the folder, returns `path`.

    A link stays, and the file that it leads to is written; a device, a pipe or a terminal is written to as it is. An
    error (OSError) leaves the old file unchanged, and no other file beside it.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    target = Path(os.path.realpath(path))
    mode = target.stat().st_mode if target.exists() else NEW
    if target.exists() and not stat.S_ISREG(mode):
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        return path
    handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.chmod(name, stat.S_IMODE(mode))
        os.replace(name, target)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return path
