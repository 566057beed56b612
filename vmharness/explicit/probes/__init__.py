"""Kinds of probe, one a file, each for the channels of a case that have one of its `KEYS`; the folder is the list."""

from typing import Any

from vmharness import plugins
from vmharness.explicit.model.model import Model
from vmharness.explicit.probe import Probe


def probe(model: Model, **channel: Any) -> Probe:
    """What shows a channel, given by its fields: `node=5, component="z-velocity"`, `energy="kinetic", part=1`.

    A node beside another key is where that is read. Raises ProbeError where the model has no such thing.
    """
    kinds = [kind for kind in plugins.modules(__name__) if not channel.keys().isdisjoint(kind.KEYS)]
    chosen = min(kinds, key=lambda kind: "node" in kind.KEYS)
    shown: Probe = chosen.probe(model, **channel)
    return shown
