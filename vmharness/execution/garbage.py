"""How often Python looks for garbage."""

import gc

RARELY = 100_000  # new objects between collections


def collect_rarely() -> None:
    """Imports make many objects and hardly any garbage: to look for it as often as usual takes a tenth of the time."""
    gc.set_threshold(RARELY)
