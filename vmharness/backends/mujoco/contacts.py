"""*CONTACT_NODES_TO_SURFACE of masses on a flat fixed surface of shells: contacts of spheres with a plane.

    k = SLSFAC SFSB K A/d      K = E/(3 (1 - 2 nu))      A area, d longer diagonal of the segment

(LS-DYNA theory manual, penalty method.) VDC in percent of the critical damping of the mass on its spring, which is
c = 2 sqrt(k m). The plane has no end.
"""

import numpy as np

from vmharness.backends.mujoco.model import Contact, Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.contact import CONTACT_NODES_TO_SURFACE
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import above, among, at_least, no_effect, only
from vmharness.deck.support import supports
from vmharness.mesh.faces import area_vectors
from vmharness.mesh.nodes import Array, Index
from vmharness.mesh.sets import node_set
from vmharness.mesh.surface import ALL, NODE_SET, ONE_PART, PART_SET, SHELL_SET, all_faces, named_faces

FLAT = 1e-9  # of the size of the surface
CARD = {
    "surfatyp": only(NODE_SET),
    "surfbtyp": among(SHELL_SET, PART_SET, ONE_PART, ALL),
    "penchk": only(0),
    "vc": only(0.0),
    "bt": only(0.0),
    "dt": at_least(1e20),
    "sfsb": above(0.0),
    "fsf": above(0.0),
    **dict.fromkeys(("saboxid", "sbboxid", "soft", "shlthk", "ignore"), only(0)),
    **dict.fromkeys(("sapr", "sbpr"), no_effect("asks for output")),
    **{name: no_effect("acts on nodes with elements of their own") for name in ("sfsa", "sast", "sfsat")},
    **{name: no_effect("the thickness of shells does not act in this contact") for name in ("sbst", "sfsbt")},
}
CONTROL = {
    "slsfac": above(0.0),
    **dict.fromkeys(("shlthk", "thkchg", "enmass", "usrstr", "usrfrc", "ignore"), only(0)),
}
SUPPORTS = (supports(CONTACT_NODES_TO_SURFACE, **CARD), supports(CONTROL_CONTACT, **CONTROL))


def add(deck: Deck, model: Model) -> None:
    """Add a contact for each card; raises DeckError where masses, surface or friction cannot be represented."""
    control = deck.first(CONTROL_CONTACT) or Entry.of_defaults(CONTROL_CONTACT)
    for place, entry in enumerate(deck.all(CONTACT_NODES_TO_SURFACE), 1):
        rows = node_set(deck, model.nodes, entry, "surfa")
        for row in rows.tolist():
            if not model.moves(row):
                what = (
                    f"mujoco: node {model.id(row)} is no mass that can move; other contacts are not supported"
                )
                raise entry.error("surfa", what)
        if entry.fs != entry.fd:
            raise entry.error("fd", "mujoco: one coefficient of friction only: FD must be FS")
        faces, stiffness = _surface(deck, model, entry)
        origin, normal, size = _plane(model, entry, faces)
        _check_over(model, entry, rows, faces)
        normal = normal * _side(model, entry, rows, origin, normal, size)
        k = control.slsfac * entry.sfsb * stiffness
        friction = entry.fsf * entry.fs
        model.contacts.append(
            Contact(entry.cid or place, rows, origin, normal, size, k, 0.01 * entry.vdc, friction)
        )


def _surface(deck: Deck, model: Model, entry: Entry) -> tuple[Index, float]:
    """The segments (n, 4), and K A/d, which is one for all of them."""
    every = all_faces(deck, model.nodes)
    faces = every.only(named_faces(deck, every, entry, "surfb", entry.surfbtyp))
    if not faces.eid.size or not faces.shell.all():
        raise entry.error("surfb", "mujoco: the surface must be one of shells")
    found = []
    for corners, pid in zip(faces.nodes, faces.pid, strict=True):
        part = deck.find(PART, pid=int(pid))
        material = deck.find(MAT_ELASTIC, mid=part.mid, referred_by=(part, "mid"))
        x = model.nodes.x0[corners]
        sides = (
            [x[2] - x[0], x[3] - x[1], x[1] - x[0]] if (x[2] == x[3]).all() else [x[2] - x[0], x[3] - x[1]]
        )
        area, longest = np.linalg.norm(area_vectors(x[None])[0]), np.linalg.norm(sides, axis=1).max()
        found.append(material.e / (3.0 * (1.0 - 2.0 * material.pr)) * area / longest)
    if max(found) - min(found) > FLAT * max(found):
        raise entry.error("surfb", "mujoco: the segments differ in stiffness: one plane has one stiffness")
    return faces.nodes, float(found[0])


def _plane(model: Model, entry: Entry, faces: Index) -> tuple[Array, Array, float]:
    """A point of the plane, its normal and the size of the surface; raises DeckError if the segments are not flat."""
    x = model.nodes.x0[np.unique(faces)]
    size = float(np.ptp(x, axis=0).max())
    area = area_vectors(model.nodes.x0[faces[:1]])[0]
    normal = area / np.linalg.norm(area)
    if np.abs((x - x[0]) @ normal).max() > FLAT * size:
        raise entry.error("surfb", "mujoco: the surface is not flat")
    return x[0], normal, size


def _check_over(model: Model, entry: Entry, rows: Index, faces: Index) -> None:
    """Each mass begins over one of the convex segments: on the inner side of its edges. The plane has no end."""
    corners = model.nodes.x0[faces]
    edges = np.roll(corners, -1, axis=1) - corners
    normals = area_vectors(corners)[:, None]
    for row in rows.tolist():
        inner = np.einsum("fij,fij->fi", np.cross(normals, edges), model.nodes.x0[row] - corners)
        if not (inner >= -FLAT * np.abs(inner).max()).all(axis=1).any():
            raise entry.error("surfa", f"mujoco: node {model.id(row)} does not begin over the surface")


def _side(model: Model, entry: Entry, rows: Index, origin: Array, normal: Array, size: float) -> float:
    """On which side of the segments the masses are, 1 or -1; masses in the plane are on that of the normal."""
    gap = (model.nodes.x0[rows] - origin) @ normal
    gap = np.where(np.abs(gap) > FLAT * size, gap, 0.0)
    if gap.min() < 0.0 < gap.max():
        raise entry.error("surfa", "mujoco: the nodes lie on both sides of the surface")
    return -1.0 if gap.min() < 0.0 else 1.0
