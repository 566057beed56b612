"""Functions of the state of MuJoCo, for the terms of channels; imported in the child process only."""

from collections.abc import Callable
from typing import Any

import mujoco
import numpy as np

Read = Callable[[], float]


def reader(model: Any, data: Any, function: str, name: str, index: int) -> Read:
    """The function of the state that a term names."""
    kind, _, quantity = function.partition(" ")
    if function == "kinetic energy":
        return lambda: float(data.energy[1])
    if function == "internal energy":  # the potential energy without its part of gravity, -sum m g . x
        weights = model.body_mass[:, None] * model.opt.gravity
        return lambda: float(data.energy[0] + (weights * data.xipos).sum())
    if function == "joint force":
        body = model.body(name).id
        return lambda: float(data.cfrc_int[body, 3 + index])
    if function == "contact force":
        return _contact_force(model, data, model.geom(name).id, index)
    if kind in ("tendon", "gap"):
        return _tendon(model, data, model.tendon(name).id, function)
    if quantity == "angular-momentum":
        return _angular_momentum(model, data, model.body(name).id, index)
    number = model.site(name).id if kind == "site" else model.body(name).id
    if quantity == "position":
        place = data.site_xpos[number] if kind == "site" else data.xipos[number]
        return lambda: float(place[index])
    of = mujoco.mjtObj.mjOBJ_SITE if kind == "site" else mujoco.mjtObj.mjOBJ_BODY
    return _velocity(model, data, of, number, index if quantity == "angular-velocity" else 3 + index)


def _velocity(model: Any, data: Any, kind: Any, number: int, place: int) -> Read:
    """A component of the motion (spin, velocity) in global axes."""
    motion = np.zeros(6)

    def read() -> float:
        mujoco.mj_objectVelocity(model, data, kind, number, motion, 0)
        return float(motion[place])

    return read


def _angular_momentum(model: Any, data: Any, body: int, axis: int) -> Read:
    """R diag(I) R^T omega, about the centre of mass."""
    motion, rotation = np.zeros(6), data.ximat[body].reshape(3, 3)

    def read() -> float:
        mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, body, motion, 0)
        return float(rotation[axis] @ (model.body_inertia[body] * (rotation.T @ motion[:3])))

    return read


def _tendon(model: Any, data: Any, number: int, function: str) -> Read:
    """The length of a tendon, or the force by its law, which MuJoCo does not give for each."""
    k, c = float(model.tendon_stiffness[number]), float(model.tendon_damping[number])
    rest = float(model.tendon_lengthspring[number, 1])  # the upper end of the dead band
    if function == "gap force":
        return lambda: max(0.0, float(k * (data.ten_length[number] - rest)))
    if function == "tendon force":
        return lambda: float(k * (data.ten_length[number] - rest) + c * data.ten_velocity[number])
    return lambda: float(data.ten_length[number])


def _contact_force(model: Any, data: Any, geom: int, axis: int) -> Read:
    """The force on a sphere, in global axes.

    MuJoCo gives the force on the second geometry, in a frame whose rows are the normal toward it and two tangents.
    """
    force = np.zeros(6)

    def read() -> float:
        total = 0.0
        for number in range(data.ncon):
            contact = data.contact[number]
            if geom in (contact.geom1, contact.geom2):
                mujoco.mj_contactForce(model, data, number, force)
                component = float(force[:3] @ contact.frame.reshape(3, 3)[:, axis])
                total += component if geom == contact.geom2 else -component
        return total

    return read
