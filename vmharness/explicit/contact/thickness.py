"""Thickness of shells in contact, and the depth at which a segment releases a node.

    t = SAST, or SFSAT times the shell's own thickness              (SBST and SFSBT on the other side)
    t <= 0.4 times the shortest side, in a single-surface contact   (SSTHK = 0)

Contacts that are not automatic use the thickness that SHLTHK says: 0: no thickness; 1: that of deformable shells; 2:
that of all shells. Solids have no thickness in any contact. A segment releases a node at this depth; D is the thickness
of a shell, or V / A behind the face of a solid:

    automatic       PENMAX D, PENMAX = 0.4 for shells and 0.5 for solids by default
    PENCHK = 0      PENMAX, and none where it is 0
    PENCHK = 1      XPENE D
    PENCHK = 2      5 % of the shortest diagonal
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from vmharness.deck import Entry
from vmharness.explicit.contact.surface.faces import ContactFaces, diagonals
from vmharness.explicit.state import Array

CAP = 0.4
RELEASE_OF_SHELL, RELEASE_OF_SOLID = 0.4, 0.5


def contact_thickness(
    faces: ContactFaces, entry: Entry, side: str, control: Mapping[str, Any], automatic: bool
) -> Array:
    """The thickness (n,) that faces have on `side` "a" or "b" of a contact, before any cap."""
    own, factor = getattr(entry, f"s{side}st"), getattr(entry, f"sfs{side}t")
    thickness = np.where(faces.shell, own or factor * faces.thickness, 0.0)
    if automatic:
        return thickness
    shlthk = entry.shlthk or control["shlthk"]
    return thickness * (shlthk > 0) * np.where(faces.rigid, shlthk == 2, True)


def capped(thickness: Array, faces: ContactFaces, x: Array) -> Array:
    """No more than 0.4 times the shortest side of each face."""
    corners = x[faces.nodes]
    sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
    return np.minimum(thickness, CAP * np.where(sides > 0.0, sides, np.inf).min(axis=1))


def release_depth(
    faces: ContactFaces, thickness: Array, x: Array, entry: Entry, control: Mapping[str, Any], automatic: bool
) -> Array:
    """How deep (n,) a node may be before it is released; infinite where it never is."""
    if automatic:
        usual = np.where(faces.shell, RELEASE_OF_SHELL, RELEASE_OF_SOLID)
        return (entry.penmax or usual) * np.where(faces.shell, thickness, faces.depth)
    if entry.penchk == 1:
        return np.asarray(control["xpene"] * faces.depth)
    if entry.penchk == 2:
        return 0.05 * diagonals(x[faces.nodes]).min(axis=1)
    return np.full(faces.pid.size, entry.penmax or np.inf)
