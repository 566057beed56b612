"""The folder for what is kept from one command to the next: compiled kernels, outcomes of studies."""

import os
from pathlib import Path


def root() -> Path:
    """$VMHARNESS_CACHE, or `vmharness` in the user's cache folder; without a home a path that cannot be written."""
    if chosen := os.environ.get("VMHARNESS_CACHE"):
        return Path(chosen)
    try:
        home = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA") or Path.home() / ".cache"
    except RuntimeError:
        home = os.devnull
    return Path(home) / "vmharness"
