"""Contact parameters: the options of cards 1 to 3, A and C that the mechanics need, and their form in kernels."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from vmharness.explicit.contact.records import Records


@dataclass(frozen=True)
class Options:
    """Options of one contact, by their names in the deck; consistent units."""

    slsfac: float = 0.1  # of *CONTROL_CONTACT; the stiffness of nodes and segments includes it
    soft: Literal[0, 1] = 0
    sofscl: float = 0.1
    fs: float = 0.0  # static and kinetic friction, mu = FD + (FS - FD) exp(-DC |v|)
    fd: float = 0.0
    dc: float = 0.0
    vc: float = np.inf  # largest shear stress, infinity where VC = 0
    vdc: float = 0.0  # percent of critical damping
    bt: float = 0.0  # birth and death
    dt: float = 1e20
    maxpar: float = 1.025  # a segment extends to this in xi and eta, so that no node passes between two
    ignore: bool = False  # an initial penetration is kept as an offset of the gap


PARAMETERS = np.dtype(
    [
        *((name, np.float64) for name in ("fs", "fd", "dc", "vc", "vdc", "sofscl", "maxpar")),
        ("ignore", np.bool_),
        ("friction", np.bool_),
        ("first_cycle", np.bool_),  # no position at t_{n-1} is known yet
        ("active", np.intp),  # number of active contacts
        ("longest_step", np.float64),  # so far
        ("travel", np.float64),  # bound of the relative motion of nodes and segments since the last sort
        ("margin", np.float64),  # relative motion for which the candidates of the last sort suffice
    ],
    align=True,
)


def parameters_of(options: Options) -> Records:
    """The parameters (1,) of a pass with these options, before the first cycle."""
    parameters = np.zeros(1, PARAMETERS)
    for name in ("fs", "fd", "dc", "vc", "vdc", "maxpar", "ignore"):
        parameters[name] = getattr(options, name)
    parameters["sofscl"] = options.sofscl if options.soft == 1 else 0.0
    parameters["friction"] = options.fs > 0.0 or options.fd > 0.0
    parameters["first_cycle"], parameters["margin"] = True, -1.0
    return parameters
