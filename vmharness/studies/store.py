"""Outcomes kept on disk by what they depend on, one file each: an interrupted study loses nothing."""

import contextlib
from dataclasses import replace
from pathlib import Path

import msgspec

from vmharness.explicit.kernels.cache import root
from vmharness.studies.measured import Measured


def path(key: str) -> Path:
    """Where the outcome of a key lies, beside the solver's compiled kernels."""
    return root() / "runs" / key[:2] / f"{key[2:]}.json"


def load(key: str) -> Measured | None:
    """The outcome kept for a key, marked as such; None where there is none that can be read."""
    try:
        return replace(msgspec.json.decode(path(key).read_bytes(), type=Measured), cached=True)
    except (OSError, msgspec.MsgspecError):
        return None


def keep(key: str, outcome: Measured) -> None:
    """Keep an outcome; where nothing can be written, nothing is kept."""
    from vmharness.execution import atomic

    with contextlib.suppress(OSError):
        atomic.write(path(key), msgspec.json.encode(outcome).decode())
