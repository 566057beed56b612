"""Write a file so that a reader finds the old content or the new, and never a part."""

import os
import tempfile
from pathlib import Path


def write(path: Path, text: str) -> Path:
    """Write `text` as UTF-8 beside `path`, then put it in its place; makes the folder, returns `path`.

    What goes wrong (OSError) leaves the old file as it was, and nothing beside it.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.chmod(name, 0o644)  # mkstemp makes a file that only its owner may read
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise
    return path
