"""The rules of a contact as its kernels read them, and how far its surfaces have moved."""

import numpy as np

from vmharness.explicit.contact.parameters import Options
from vmharness.explicit.contact.records import Records

RULE = np.dtype(
    [
        *((name, np.float64) for name in ("fs", "fd", "dc", "vc", "vdc", "sofscl", "maxpar")),
        ("ignore", np.bool_),
        ("friction", np.bool_),
        ("start", np.bool_),  # the first cycle: nothing has come from anywhere yet
        ("longest", np.float64),  # step so far
        (
            "travel",
            np.float64,
        ),  # how far nodes and segments can have moved against each other since they were sorted
        ("margin", np.float64),  # how far they may, before what was found is no longer all there is
    ],
    align=True,
)


def rule_of(options: Options) -> Records:
    """The rule (1,) of these options, before the first cycle."""
    rule = np.zeros(1, RULE)
    for name in ("fs", "fd", "dc", "vc", "vdc", "maxpar", "ignore"):
        rule[name] = getattr(options, name)
    rule["sofscl"] = options.sofscl if options.soft == 1 else 0.0
    rule["friction"] = options.fs > 0.0 or options.fd > 0.0
    rule["start"], rule["margin"] = True, -1.0
    return rule
