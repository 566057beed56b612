"""Rigid bodies of the deck: *MAT_RIGID, *PART_INERTIA, *CONSTRAINED_NODAL_RIGID_BODY and what goes with them.

Mass, centre and inertia are sums over the nodes of a body, of all mass and rotary inertia that is lumped there, also
by deformable elements that share them; or they are what the _INERTIA cards give, and what the nodes have is left out.

Velocities at t = 0, the later ruling: those of the nodes, as the rigid motion of the same momentum and angular
momentum; those of the _INERTIA cards, zeros too; those of *INITIAL_VELOCITY_RIGID_BODY. What CMO holds is at rest.
"""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.damping.mass import MassDamping
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Array
from vmharness.explicit.rigid.bearing import bear, share_given
from vmharness.explicit.rigid.bodies import Bodies, Drive, Gather
from vmharness.explicit.rigid.check import check_free, check_joints, check_scaling, check_whole
from vmharness.explicit.rigid.inertia import Inertia, principal, quaternion
from vmharness.explicit.rigid.joints import joints
from vmharness.explicit.rigid.members import Member, inertia_of, members
from vmharness.explicit.rigid.velocity import velocities

Index = NDArray[np.intp]

LISTED = 10  # bodies whose mass and inertia are facts of the run; more are only counted


def build(deck: Deck, model: Model) -> None:
    """Take the nodes of all rigid bodies over: their mass goes to the centre."""
    found = members(deck, model)
    if not found:
        return
    check_free(model, found)
    check_whole(model, found)
    check_scaling(model, found)
    centre = np.array([model.centre(member.number) for member in found], np.intp)
    inertia = [inertia_of(model, member) for member in found]
    velocity = velocities(deck, model, found, inertia)
    model.state.lumped = model.state.mass.copy()
    for row, member, one, (v, omega) in zip(centre, found, inertia, velocity, strict=True):
        _place(model, row, member, one, v, omega)
    motions = _motions(model, centre)
    for motion in motions:
        motion.begin(model)  # it overrules
    for row, member in zip(centre, found, strict=True):
        _set_nodes(model, row, member.nodes)
    bodies = _bodies(model, found, inertia, centre, motions)
    inverse_mass = np.zeros(model.ids.size)
    inverse_mass[centre] = 1.0 / np.array([one.mass for one in inertia])
    movable = np.where(bodies.held[:, :3], 0.0, inverse_mass[centre][:, None])
    body = np.repeat(np.arange(len(found)), np.diff(bodies.first))
    bodies.joints = joints(deck, model, bodies.nodes, body, movable)
    if bodies.joints is not None:
        check_joints(deck, bodies, motions)
    bear(model, bodies)
    share_given(model, bodies, [member.has_inertia for member in found])
    model.constraints.insert(0, Gather(bodies, inverse_mass))
    model.constraints.append(bodies)
    model.kinetic.others.append(bodies.kinetic)
    _say(model, found, inertia)


def _ruled(model: Model, found: list[Member]) -> NDArray[np.bool_]:
    """All degrees of freedom of the nodes, and what CMO holds of the centres."""
    fixed = np.zeros((model.ids.size, 6), bool)
    for member in found:
        fixed[member.nodes] = True
        fixed[model.centre(member.number)] = member.held
    return fixed


def _bodies(
    model: Model, found: list[Member], inertia: list[Inertia], centre: Index, motions: list[PrescribedMotion]
) -> Bodies:
    """The bodies as arrays, from the state at t = 0."""
    moments, axes = zip(*(principal(one.tensor) for one in inertia), strict=True)
    sizes = [member.nodes.size for member in found]
    inverse = np.divide(1.0, moments, out=np.zeros((len(found), 3)), where=np.array(moments) > 0.0)
    return Bodies(
        numbers=np.array([member.number for member in found]),
        centre=centre,
        first=np.concatenate([[0], np.cumsum(sizes)]).astype(np.intp),
        nodes=np.concatenate([member.nodes for member in found]),
        arm=np.concatenate([
            (model.x0[m.nodes] - one.centre) @ e for m, one, e in zip(found, inertia, axes, strict=True)
        ]),
        q=np.array([quaternion(e) for e in axes]),
        principal=np.array(moments),
        inverse=inverse,
        L=np.array([one.tensor @ model.state.omega[row] for one, row in zip(inertia, centre, strict=True)]),
        held=np.array([member.held for member in found]),
        drives=[_drive(motion, centre) for motion in motions if motion.dof >= 3],
        damping=_damping(model),
        fixed=_ruled(model, found),
    )  # fmt: skip


def _place(model: Model, row: int, member: Member, inertia: Inertia, v: Array, omega: Array) -> None:
    """Put the body's mass and velocity on the row of its centre, and leave none on its nodes."""
    s, held = model.state, member.held
    v, omega = np.where(held[:3], 0.0, v), np.where(held[3:], 0.0, omega)
    s.mass[member.nodes] = s.inertia[member.nodes] = 0.0
    s.mass[row] = inertia.mass
    s.x[row] = model.x0[row] = inertia.centre
    s.v[row], s.omega[row] = v, omega


def _set_nodes(model: Model, centre: np.intp, nodes: Index) -> None:
    """v_k = v_c + omega x r of the nodes."""
    s = model.state
    s.v[nodes] = s.v[centre] + np.cross(s.omega[centre], s.x[nodes] - s.x[centre])
    s.omega[nodes] = s.omega[centre]


def _motions(model: Model, centre: Index) -> list[PrescribedMotion]:
    """Prescribed motions of centres."""
    motions = [item for item in model.constraints if isinstance(item, PrescribedMotion)]
    return [motion for motion in motions if np.isin(motion.nodes, centre).any()]


def _drive(motion: PrescribedMotion, centre: Index) -> Drive:
    return Drive(int(np.flatnonzero(centre == motion.nodes[0])[0]), motion.axis, motion.total)


def _damping(model: Model) -> Array | None:
    """D S (n, 6) of mass damping, kept up to date by it."""
    return next((item.rate for item in model.constraints if isinstance(item, MassDamping)), None)


def _say(model: Model, found: list[Member], inertia: list[Inertia]) -> None:
    if len(found) > LISTED:
        model.facts["Rigid bodies"] = str(len(found))
        return
    for member, one in zip(found, inertia, strict=True):
        centre = ", ".join(f"{value:.6g}" for value in one.centre)
        moments = ", ".join(f"{value:.6g}" for value in sorted(np.linalg.eigvalsh(one.tensor)))
        model.facts[f"Rigid body {member.number}"] = (
            f"mass {one.mass:.6g}, centre ({centre}), principal moments {moments}"
        )
