"""An open verification manual for explicit dynamics, and the harness that runs it."""

from importlib.metadata import version

__version__ = version("vmharness")
