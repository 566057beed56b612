"""Rigid bodies of the deck: *MAT_RIGID, *PART_INERTIA, *CONSTRAINED_NODAL_RIGID_BODY and the cards that go with them.

Mass, centre and inertia of a body are sums over its nodes, of all mass and rotary inertia that is lumped there, also by
deformable elements that share the nodes; or they are those of the _INERTIA cards, and the mass of the nodes is left
out. What CMO holds is at rest.
"""

import numpy as np

from vmharness.deck import Deck
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.damping.mass import MassDamping
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.bodies import Bodies
from vmharness.explicit.rigid.body import RigidBody, body_inertia, find_bodies
from vmharness.explicit.rigid.check import (
    check_constraints,
    check_joints,
    check_mass_loads,
    check_mass_scaling,
)
from vmharness.explicit.rigid.constraints import BodyForces, Drive, RigidBodies
from vmharness.explicit.rigid.inertia import Inertia, principal_axes, quaternion
from vmharness.explicit.rigid.initial_velocity import body_velocities
from vmharness.explicit.rigid.joint_cards import build_joints
from vmharness.explicit.rigid.mass_shares import share_body_mass, share_lumped_mass
from vmharness.explicit.state import Array, Flags, Index

LISTED = 10  # bodies whose mass and inertia are facts of the run; of more bodies only the number is


def build(deck: Deck, model: Model) -> None:
    """Move the mass of all rigid bodies from their nodes to their centres, and add the constraints of their motion."""
    found = find_bodies(deck, model)
    if not found:
        return
    check_constraints(model, found)
    check_mass_loads(model, found)
    check_mass_scaling(model, found)
    centre = np.array([model.centre(body.number) for body in found], np.intp)
    inertia = [body_inertia(model, body) for body in found]
    velocity = body_velocities(deck, model, found, inertia)
    model.state.lumped = model.state.mass.copy()
    for row, body, one, (v, omega) in zip(centre, found, inertia, velocity, strict=True):
        _set_centre(model, row, body, one, v, omega)
    motions = _motions(model, centre)
    for motion in motions:
        motion.begin(model, at_rest=motion.dof < 3)  # its velocity overrules that of the body
    for row, body in zip(centre, found, strict=True):
        _set_nodes(model, row, body.nodes)
    _add_constraints(deck, model, found, _bodies(model, found, inertia, centre), motions)
    _add_facts(model, found, inertia)


def _set_centre(model: Model, row: int, body: RigidBody, inertia: Inertia, v: Array, omega: Array) -> None:
    """Put mass, position and velocity of the body on the row of its centre, and leave no mass on its nodes."""
    s, held = model.state, body.held
    v, omega = np.where(held[:3], 0.0, v), np.where(held[3:], 0.0, omega)
    s.mass[body.nodes] = s.inertia[body.nodes] = 0.0
    s.mass[row] = inertia.mass
    s.x[row] = model.x0[row] = inertia.centre
    s.v[row], s.omega[row] = v, omega


def _set_nodes(model: Model, centre: np.intp, nodes: Index) -> None:
    """Set v_k = v_c + omega x r of the nodes."""
    s = model.state
    s.v[nodes] = s.v[centre] + np.cross(s.omega[centre], s.x[nodes] - s.x[centre])
    s.omega[nodes] = s.omega[centre]


def _bodies(model: Model, found: list[RigidBody], inertia: list[Inertia], centre: Index) -> Bodies:
    """The arrays of the bodies, from the state at t = 0."""
    moments, axes = zip(*(principal_axes(one.tensor) for one in inertia), strict=True)
    sizes = [body.nodes.size for body in found]
    inverse_mass = np.zeros(model.ids.size)
    inverse_mass[centre] = 1.0 / np.array([one.mass for one in inertia])
    return Bodies(
        numbers=np.array([body.number for body in found]),
        centre=centre,
        first=np.concatenate([[0], np.cumsum(sizes)]).astype(np.intp),
        nodes=np.concatenate([body.nodes for body in found]),
        arm=np.concatenate([
            (model.x0[b.nodes] - one.centre) @ e for b, one, e in zip(found, inertia, axes, strict=True)
        ]),
        q=np.array([quaternion(e) for e in axes]),
        principal=np.array(moments),
        inverse=np.divide(1.0, moments, out=np.zeros((len(found), 3)), where=np.array(moments) > 0.0),
        L=np.array([one.tensor @ model.state.omega[row] for one, row in zip(inertia, centre, strict=True)]),
        inverse_mass=inverse_mass,
        given=np.array([body.held[3:] for body in found]),
    )  # fmt: skip


def _add_constraints(
    deck: Deck, model: Model, found: list[RigidBody], bodies: Bodies, motions: list[PrescribedMotion]
) -> None:
    """Add the constraints of the bodies, with joints, driven rotations and damping."""
    held = np.array([body.held for body in found])
    movable = np.where(held[:, :3], 0.0, bodies.inverse_mass[bodies.centre][:, None])
    damping = _damping_rates(model)
    drives = [_drive(motion, bodies.centre) for motion in motions if motion.dof >= 3]
    for drive in drives:
        bodies.given[drive.body, drive.axis] = True
    joints = build_joints(deck, model, bodies, movable)
    if joints is not None:
        check_joints(deck, damping, motions)
    share_body_mass(model, bodies)
    share_lumped_mass(model, bodies, [body.inertia_given for body in found])
    model.constraints.insert(0, BodyForces(bodies, model.ids.size))
    model.constraints.append(RigidBodies(bodies, held, _fixed(model, found), drives, damping, joints))
    model.kinetic.others.append(bodies.kinetic)


def _fixed(model: Model, found: list[RigidBody]) -> Flags:
    """Degrees of freedom (n, 6) that need no mass: all of the nodes, and those of the centres that CMO holds."""
    fixed = np.zeros((model.ids.size, 6), bool)
    for body in found:
        fixed[body.nodes] = True
        fixed[model.centre(body.number)] = body.held
    return fixed


def _motions(model: Model, centre: Index) -> list[PrescribedMotion]:
    """Prescribed motions of centres."""
    motions = [item for item in model.constraints if isinstance(item, PrescribedMotion)]
    return [motion for motion in motions if np.isin(motion.nodes, centre).any()]


def _drive(motion: PrescribedMotion, centre: Index) -> Drive:
    return Drive(int(np.flatnonzero(centre == motion.nodes[0])[0]), motion.axis, motion.total)


def _damping_rates(model: Model) -> Array | None:
    """D S (n, 6) of mass damping, an array that the damping updates; None without damping."""
    return next((item.rate for item in model.constraints if isinstance(item, MassDamping)), None)


def _add_facts(model: Model, found: list[RigidBody], inertia: list[Inertia]) -> None:
    """Add mass, centre and principal moments of the bodies to the facts of the run."""
    if len(found) > LISTED:
        model.facts["Rigid bodies"] = str(len(found))
        return
    for body, one in zip(found, inertia, strict=True):
        centre = ", ".join(f"{value:.6g}" for value in one.centre)
        moments = ", ".join(f"{value:.6g}" for value in sorted(np.linalg.eigvalsh(one.tensor)))
        model.facts[f"Rigid body {body.number}"] = (
            f"mass {one.mass:.6g}, centre ({centre}), principal moments {moments}"
        )
