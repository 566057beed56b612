"""Where compiled kernels lie on disk, so that a changed source never runs as it was before.

numba does not notice when a function that a cached kernel calls in another file has changed. The cache therefore
lies in a folder named by a hash of every source file of the solver (kernels call nothing else of ours), numba's version
and the processor: a changed source is a new folder.
"""

import hashlib
import os
import platform
import shutil
from importlib.metadata import version
from pathlib import Path

KEEP = 4  # folders of other sources or machines that share the cache; older ones are removed
KEEP_PLANTED = 64  # one for each fault that is planted
PLANTED = "VMHARNESS_PLANTED"  # names the fault that this process has in its sources, if any


def root() -> Path:
    """The folder that holds the caches of all versions: $VMHARNESS_CACHE, or the user's cache folder."""
    if chosen := os.environ.get("VMHARNESS_CACHE"):
        return Path(chosen)
    home = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA") or str(Path.home() / ".cache")
    return Path(home) / "vmharness"


def folder() -> Path:
    """The folder for kernels of just these sources, this numba and this processor, and of just this planted fault."""
    digest, planted = hashlib.sha256(), os.environ.get(PLANTED, "")
    package = Path(__file__).parents[1]
    for source in sorted(package.rglob("*.py")):
        digest.update(source.relative_to(package).as_posix().encode())
        digest.update(source.read_bytes())
    for fact in (version("numba"), platform.python_version(), platform.machine(), _processor(), planted):
        digest.update(fact.encode())
    return root() / f"{'planted' if planted else 'kernels'}-{digest.hexdigest()[:16]}"


def is_cold() -> bool:
    """True when nothing is compiled yet, so that the first run will take longer."""
    return not any(folder().rglob("*.nbi"))


def prepare() -> bool:
    """Point numba at the folder, before numba is imported; False where no folder can be made."""
    chosen = folder()
    try:
        chosen.mkdir(parents=True, exist_ok=True)
        os.utime(chosen)
        _clean(chosen)
    except OSError:
        return False
    os.environ["NUMBA_CACHE_DIR"] = str(chosen)
    return True


def _processor() -> str:
    """The processor's model name: compiled code may use instructions that another model lacks."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    return next((line for line in lines if line.startswith("model name")), platform.processor())


def _clean(current: Path) -> None:
    """Remove all but the most recently used other folders of its kind: sound kernels, or planted ones."""
    kind = current.name.partition("-")[0]
    keep = KEEP if kind == "kernels" else KEEP_PLANTED
    others = [other for other in root().glob(f"{kind}-*") if other != current]
    for other in sorted(others, key=lambda other: other.stat().st_mtime, reverse=True)[keep:]:
        shutil.rmtree(other, ignore_errors=True)
