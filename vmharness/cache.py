"""The folder for what is kept from one command to the next: compiled kernels, outcomes of studies."""

import os
from pathlib import Path


def root() -> Path:
    """$VMHARNESS_CACHE, or `vmharness` in the user's cache folder."""
    if chosen := os.environ.get("VMHARNESS_CACHE"):
        return Path(chosen)
    home = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA") or str(Path.home() / ".cache")
    return Path(home) / "vmharness"
