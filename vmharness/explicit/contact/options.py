"""Cards of a contact -> the options of its mechanics."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from vmharness.deck import Entry
from vmharness.explicit.contact.parameters import Options


def options_of(entry: Entry, control: Mapping[str, Any]) -> Options:
    """Friction FSF FS and FSF FD, limited by the shear stress VSF VC; damping, birth and death, SOFT, IGNORE."""
    if entry.fs == 2.0:
        raise entry.error("fs", "stands for a table of friction coefficients, which is not supported")
    if entry.dt <= entry.bt:
        raise entry.error("dt", f"the contact would end before its birth at {entry.bt:g}")
    return Options(
        soft=entry.soft,
        sofscl=entry.sofscl,
        fs=entry.fsf * entry.fs,
        fd=entry.fsf * entry.fd,
        dc=entry.dc,
        vc=entry.vsf * entry.vc if entry.vc > 0.0 else np.inf,
        vdc=entry.vdc,
        bt=entry.bt,
        dt=entry.dt,
        maxpar=entry.maxpar,
        ignore=keeps_penetrations(entry, control),
    )


def keeps_penetrations(entry: Entry, control: Mapping[str, Any]) -> bool:
    """Whether initial penetrations stay, as offsets of the gap: IGNORE of card C, or else of *CONTROL_CONTACT."""
    return bool(entry.ignore or control["ignore"])
