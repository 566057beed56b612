"""An open verification manual for explicit dynamics, and the harness that runs it."""


def __getattr__(name: str) -> str:
    """`vmharness.__version__`, looked up when asked for: `vm --help` does without it."""
    if name == "__version__":
        from importlib.metadata import version

        return version("vmharness")
    raise AttributeError(name)
