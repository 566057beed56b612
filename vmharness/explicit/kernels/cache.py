"""Compiled kernels on disk: one file for each kernel and each set of argument types.

The name of a file is a hash of what the kernel computes (meaning.py), of the argument types and of the processor's
features. A kernel with a changed operator is therefore another file; one with a changed comment, or in another copy of
the package, is the same. The folder is named by what makes the files: Python, the compiler, the processor.
"""

import contextlib
import hashlib
import os
import platform
import shutil
import tempfile
import time
import zlib
from functools import cache
from importlib.metadata import version
from pathlib import Path

from vmharness.cache import root

FOLDERS = 4  # folders of other compilers and processors that stay
FILES = 8000  # kernels that stay, about 350 MB
DAY = 86400.0  # s
HEAD = 4  # bytes of the checksum at the start of a file


def folder() -> Path:
    """The folder for kernels of this Python, this compiler and this processor."""
    packages = [version(name) for name in ("numba", "llvmlite", "numpy")]
    facts = (platform.python_version(), platform.machine(), _processor(), *packages)
    return root() / f"kernels-{hashlib.sha256(repr(facts).encode()).hexdigest()[:16]}"


def is_cold() -> bool:
    """True when nothing is compiled yet, so that the first run takes longer."""
    try:
        with os.scandir(folder()) as kernels:
            return next(kernels, None) is None
    except OSError:
        return True


def unwritable() -> str:
    """Why no kernel can be kept; "" where it can."""
    try:
        folder().mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder()) as file:
            file.write(b"0")
    except OSError as error:
        return f"{folder()}: {error.strerror}"
    return ""


def load(path: Path) -> bytes | None:
    """The content of a file; None where there is none, or where it is damaged."""
    try:
        content = path.read_bytes()
        if _checksum(content[HEAD:]) != content[:HEAD]:
            return None
        if time.time() - path.stat().st_mtime > DAY:
            os.utime(path)  # in use: not to be removed
    except OSError:
        return None
    return content[HEAD:]


def save(path: Path, content: bytes) -> None:
    """Write a file in one step; where that cannot be, the kernel serves this process only."""
    with contextlib.suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        clean(path.parent)
        number, part = tempfile.mkstemp(dir=path.parent, suffix=".part")
        try:
            with os.fdopen(number, "wb") as file:
                file.write(_checksum(content) + content)
            Path(part).replace(path)
        finally:
            Path(part).unlink(missing_ok=True)


@cache
def clean(current: Path) -> None:
    """Remove the kernels and the other folders that were not used for longest, once in a process."""
    kernels = list(current.iterdir())
    if len(kernels) > FILES:
        _keep_newest(FILES * 3 // 4, kernels)  # so that the next time is far off
    _keep_newest(FOLDERS, [other for other in current.parent.glob("kernels-*") if other != current])


def _keep_newest(most: int, paths: list[Path]) -> None:
    for path in sorted(paths, key=_used, reverse=True)[most:]:
        if path.is_dir():
            shutil.rmtree(path, ignore_errors=True)
        else:
            path.unlink(missing_ok=True)


def _used(path: Path) -> float:
    """When it was used last; 0 where another process has removed it."""
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0


def _checksum(content: bytes) -> bytes:
    return zlib.crc32(content).to_bytes(HEAD, "little")


def _processor() -> str:
    """The processor's model name: compiled code may use instructions that another model lacks."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    return next((line for line in lines if line.startswith("model name")), platform.processor())
