"""Spherical and revolute joints as the joints of a tree of bodies, which are exact: no constraint that can give way."""

import numpy as np

from vmharness.backends.mujoco.model import Body, Joint, Model
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.joint import CONSTRAINED_JOINT_REVOLUTE, CONSTRAINED_JOINT_SPHERICAL
from vmharness.deck.rule import no_effect, only
from vmharness.deck.support import supports

KINDS = (CONSTRAINED_JOINT_SPHERICAL, CONSTRAINED_JOINT_REVOLUTE)
FURTHER = {
    **dict.fromkeys(("n5", "n6"), only(0)),
    **dict.fromkeys(("rps", "damp"), no_effect("acts on joints by penalty")),
}
SUPPORTS = (
    supports(CONSTRAINED_JOINT_SPHERICAL, n3=only(0), n4=only(0), **FURTHER),
    supports(CONSTRAINED_JOINT_REVOLUTE, **FURTHER),
)
CONSISTENT = 1e-6  # of the velocities: cards have few digits


def add(deck: Deck, model: Model) -> None:
    """Join the bodies; raises DeckError for a closed loop, and for velocities that a joint does not allow."""
    entries = [entry for entry in deck.entries if entry.keyword in KINDS]
    pairs = [(_owner(model, entry, "n1"), _owner(model, entry, "n2")) for entry in entries]
    places: dict[int, tuple[int, float]] = {}
    reached = {number for number, body in model.bodies.items() if body.fixed}
    starts = [*reached, *model.bodies]
    for start in starts:
        reached.add(start)
        _grow(model, entries, pairs, start, reached, places)
    for place, entry in enumerate(entries):
        if place not in places:
            raise entry.error(None, "mujoco: the joint closes a loop of bodies, which is not supported")
    model.joints = [places[place] for place in range(len(entries))]


def _grow(
    model: Model,
    entries: list[Entry],
    pairs: list[tuple[Body, Body]],
    start: int,
    reached: set[int],
    places: dict[int, tuple[int, float]],
) -> None:
    """Join to the body `start`, and to all that hang on it, the bodies that no other joint has reached."""
    for place, (entry, (one, other)) in enumerate(zip(entries, pairs, strict=True)):
        for parent, child, sign in ((one, other, -1.0), (other, one, 1.0)):
            if parent.number == start and child.number not in reached:
                child.joint = _joint(model, entry, parent, child)
                places[place] = child.number, sign
                reached.add(child.number)
                _grow(model, entries, pairs, child.number, reached, places)


def _owner(model: Model, entry: Entry, name: str) -> Body:
    body = model.owner.get(model.nodes.row(entry, name, getattr(entry, name)))
    if body is None:
        raise entry.error(name, "mujoco: no node of a rigid body")
    return body


def _joint(model: Model, entry: Entry, parent: Body, child: Body) -> Joint:
    x = model.nodes.x0
    anchor = x[model.nodes.row(entry, "n1", entry.n1)]
    axis = None
    if entry.keyword is CONSTRAINED_JOINT_REVOLUTE:
        axis = x[model.nodes.row(entry, "n3", entry.n3)] - anchor
        if not axis.any():
            raise entry.error("n3", "lies where N1 lies: the joint has no axis")
        axis = axis / np.linalg.norm(axis)
    _check_velocities(entry, parent, child, anchor, axis)
    return Joint(None if parent.fixed else parent, anchor, axis)


def _check_velocities(
    entry: Entry, parent: Body, child: Body, anchor: np.ndarray, axis: np.ndarray | None
) -> None:
    """Both bodies have one velocity at the joint, and one spin across the axis of a revolute joint."""
    motions = [
        (np.zeros(3), np.zeros(3))
        if body.fixed
        else (body.v + np.cross(body.omega, anchor - body.centre), body.omega)
        for body in (parent, child)
    ]
    gap, spin = motions[1][0] - motions[0][0], motions[1][1] - motions[0][1]
    if np.abs(gap).max() > CONSISTENT * np.abs([parent.v, child.v]).max():
        raise entry.error("n1", "mujoco: the initial velocities of the two bodies differ at the joint")
    if axis is not None and np.abs(spin - (spin @ axis) * axis).max() > CONSISTENT * np.abs(spin).max():
        raise entry.error("n3", "mujoco: the bodies rotate about another axis than that of the joint")
