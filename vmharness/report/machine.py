"""The machine of a run, and the versions of what ran there."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

PACKAGES = ("numpy", "numba", "scipy", "matplotlib")


def host() -> str:
    """The name of the machine in its network."""
    return platform.node()


def python() -> str:
    """Version and implementation."""
    return f"{platform.python_version()} ({platform.python_implementation()})"


def system() -> str:
    """Operating system and its release."""
    return f"{platform.system()} {platform.release()}"


def versions() -> dict[str, str]:
    """The versions of the packages on which digits or pages depend."""
    found = {}
    for package in PACKAGES:
        try:
            found[package] = version(package)
        except PackageNotFoundError:
            found[package] = "not installed"
    return found


def processor() -> str:
    """The model of the processor; platform.processor() is empty on most Linux."""
    path = Path("/proc/cpuinfo")
    lines = path.read_text(errors="replace").splitlines() if path.is_file() else []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return models[0] if models else platform.processor() or platform.machine()


def cores() -> int:
    """Number of the processor's cores."""
    return os.cpu_count() or 1
