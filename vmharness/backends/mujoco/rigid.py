"""Rigid parts: mass, centre and inertia by *PART_INERTIA, or those of the trusses and masses at their nodes.

MuJoCo needs a positive moment of inertia about every axis. A rod of trusses has none about its own axis: it gets the
fraction `LEAST` of its largest moment there, and does not spin about it.
"""

import numpy as np

from vmharness.backends.mujoco.model import Body, Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.extra_nodes import CONSTRAINED_EXTRA_NODES_NODE
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART, has_inertia
from vmharness.deck.keywords.section.solid import SECTION_SOLID
from vmharness.deck.rule import among, only
from vmharness.deck.support import supports
from vmharness.mesh.nodes import Array, Index
from vmharness.mesh.sets import nodes_of_parts

LEAST = 1e-6  # of the largest principal moment
ROUND_OFF = 1e-14  # by which a flat body must stay below I3 = I1 + I2, for MuJoCo refuses more
DIGITS = 1e-9  # by which a card may exceed it
HELD = 7  # code of three axes
SUPPORTS = (
    supports(MAT_RIGID, cmo=among(0, 1), n=only(0.0), couple=only(0.0), spcnid=only(0)),
    supports(SECTION_SOLID),
    supports(CONSTRAINED_EXTRA_NODES_NODE, iflag=only(0)),
)


def add(deck: Deck, model: Model) -> None:
    """Add each rigid part as a body that owns its nodes; raises DeckError for what it cannot represent."""
    rigid = {entry.mid for entry in deck.all(MAT_RIGID)}
    for part in deck.all(PART):
        if part.mid in rigid:
            body = _body(deck, model, part)
            model.bodies[part.pid] = body
            for row in body.rows.tolist():
                if row in model.owner:
                    raise part.error("pid", f"mujoco: node {model.id(row)} belongs to another rigid body")
                model.owner[row] = body
        elif has_inertia(part):
            raise part.error("mid", "*PART_INERTIA is for parts of *MAT_RIGID")
    for entry in deck.all(CONSTRAINED_EXTRA_NODES_NODE):
        deck.find(PART, pid=entry.pid, referred_by=(entry, "pid"))


def _body(deck: Deck, model: Model, part: Entry) -> Body:
    material = deck.find(MAT_RIGID, mid=part.mid, referred_by=(part, "mid"))
    fixed = bool(material.cmo == 1 and material.con1 == HELD and material.con2 == HELD)
    if material.cmo and not fixed:
        raise material.error(
            "con1", "mujoco: a rigid body is free, or held in all directions: CON1 = CON2 = 7"
        )
    extra = [
        model.nodes.row(entry, "nid", entry.nid)
        for entry in deck.all(CONSTRAINED_EXTRA_NODES_NODE)
        if entry.pid == part.pid
    ]
    rows = np.union1d(nodes_of_parts(deck, model.nodes, {part.pid}), np.array(extra, np.intp)).astype(np.intp)
    _check_nodes(model, part, rows)
    mass, centre, tensor = _given(model, part, rows) if has_inertia(part) else _of_points(model, part, rows)
    v = np.array([part.vtx, part.vty, part.vtz]) if has_inertia(part) else np.zeros(3)
    omega = np.array([part.vrx, part.vry, part.vrz]) if has_inertia(part) else np.zeros(3)
    return Body(part.pid, part, rows, fixed, mass, centre, tensor, v, omega)


def _check_nodes(model: Model, part: Entry, rows: Index) -> None:
    """Nodes of a body have no supports and no velocities of their own here."""
    for row in rows.tolist():
        if model.held[row].any():
            raise part.error("pid", f"mujoco: node {model.id(row)} of the rigid body is held by a support")
        if model.v[row].any() and not has_inertia(part):
            raise part.error(
                "pid", f"mujoco: initial velocities of nodes, here {model.id(row)}, do not move a rigid body"
            )


def _given(model: Model, part: Entry, rows: Index) -> tuple[float, Array, Array]:
    """Mass, centre and tensor of the cards, in global axes."""
    if part.ircs:
        raise part.error("ircs", "mujoco: inertia in local axes is not supported")
    if model.mass[rows].any():
        raise part.error("pid", "mujoco: a body of given inertia with masses at its nodes is not supported")
    xx, xy, xz, yy, yz, zz = (getattr(part, name) for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    moments = np.linalg.eigvalsh(tensor)
    if not (part.tm > 0.0 and moments[0] > 0.0):
        raise part.error("tm", "mujoco: mass and principal moments must be greater than 0")
    if moments[2] > (1.0 + DIGITS) * (moments[0] + moments[1]):
        given = ", ".join(f"{moment:.9g}" for moment in moments)
        raise part.error(
            "ixx", f"mujoco: of the principal moments {given} the last exceeds the sum of the others"
        )
    at = np.array([part.xc, part.yc, part.zc])
    centre = model.nodes.x0[model.nodes.row(part, "nodeid", part.nodeid)] if part.nodeid else at
    return part.tm, centre, _possible(tensor, 0.0)


def _of_points(model: Model, part: Entry, rows: Index) -> tuple[float, Array, Array]:
    """I = sum m (r^2 E - r r^T) about the centre of the masses at the nodes."""
    m, x = model.mass[rows], model.nodes.x0[rows]
    if not m.any():
        raise part.error("pid", "mujoco: the rigid body has no mass: give *PART_INERTIA, or trusses")
    centre = m @ x / m.sum()
    r = x - centre
    tensor = (m @ (r**2).sum(axis=1)) * np.eye(3) - (m[:, None] * r).T @ r
    if not tensor.any():
        raise part.error("pid", "mujoco: the rigid body is a point, without a moment of inertia")
    return float(m.sum()), centre, _possible(tensor, LEAST)


def _possible(tensor: Array, least: float) -> Array:
    """The tensor, with principal moments that MuJoCo takes: not below `least` of the largest, and I3 < I1 + I2."""
    moments, axes = np.linalg.eigh(tensor)
    taken = np.maximum(moments, least * moments[2])
    taken[2] = min(taken[2], (1.0 - ROUND_OFF) * (taken[0] + taken[1]))
    return tensor if (taken == moments).all() else np.asarray(axes @ np.diag(taken) @ axes.T)
