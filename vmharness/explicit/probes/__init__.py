"""Probes: functions of no argument that read a quantity of a running model at t_n.

Contract of a module of this folder: `PROBES` maps keys of channels to functions `(model, **channel) -> Probe`. Such a
function raises ProbeError for a quantity that the model does not have.
"""

from typing import Any

from vmharness import plugins
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes._quantity import Probe, ProbeError

__all__ = ["Probe", "ProbeError", "probe"]


def probe(model: Model, **channel: Any) -> Probe:
    """The probe of a channel, given by its fields: `node=5, component="z-velocity"`, `energy="kinetic", part=1`.

    A node beside another key is the place at which that quantity is read. Raises ProbeError.
    """
    modules = plugins.modules(__name__, "PROBES")
    found = {key: make for module in modules for key, make in module.PROBES.items() if key in channel}
    key = min(found, key=lambda key: key == "node")
    made: Probe = found[key](model, **channel)
    return made
