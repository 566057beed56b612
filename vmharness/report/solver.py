"""Name of a solver without its version."""

import re


def short_name(solver: str) -> str:
    """The name of a solver without its version.

    >>> short_name("vmharness 0.1.0"), short_name("LS-DYNA"), short_name("")
    ('vmharness', 'LS-DYNA', 'solver')
    """
    return re.sub(r"\s+v?\d\S*$", "", solver) or "solver"
