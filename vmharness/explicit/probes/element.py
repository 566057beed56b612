"""Stresses and forces of an element."""

import numpy as np

from vmharness.explicit.force import Elements
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes._quantity import Probe, ProbeError


def of_element(model: Model, component: str, point: int = 1, **element: int) -> Probe:
    """A component of stress or force in the own frame of an element, `shell=7`: `xx-stress`, `axial-force`."""
    ((kind, eid),) = element.items()
    for force in model.forces:
        if isinstance(force, Elements) and force.kind == kind and eid in force.eid:
            try:
                return force.probe(int(np.flatnonzero(force.eid == eid)[0]), point, component)
            except ValueError as error:
                raise ProbeError(str(error)) from None
    raise ProbeError(f"no {kind} element {eid} in the deck")


PROBES = dict.fromkeys(("shell", "solid", "beam", "discrete"), of_element)
