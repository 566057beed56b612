"""*CONSTRAINED_JOINT_SPHERICAL and *CONSTRAINED_JOINT_REVOLUTE of the deck -> the joints of its rigid bodies."""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.constrained.joint import CONSTRAINED_JOINT_REVOLUTE, CONSTRAINED_JOINT_SPHERICAL
from vmharness.deck.rule import no_effect, only
from vmharness.deck.support import supports
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.bodies import Bodies
from vmharness.explicit.rigid.joints import Joints, Pair
from vmharness.explicit.state import Array, Index

PENALTY = {name: no_effect("acts on joints by penalty") for name in ("rps", "damp")}
FURTHER = {"n5": only(0), "n6": only(0), **PENALTY}

SUPPORTS = (
    supports(CONSTRAINED_JOINT_SPHERICAL, n3=only(0), n4=only(0), **FURTHER),
    supports(CONSTRAINED_JOINT_REVOLUTE, **FURTHER),
)

KINDS = (CONSTRAINED_JOINT_SPHERICAL, CONSTRAINED_JOINT_REVOLUTE)
COINCIDENT = 1e-9  # of the size of the model: nodes that are nearer lie at one point


def joint_entries(deck: Deck) -> list[Entry]:
    """The joints in the deck's order."""
    return [entry for entry in deck.entries if entry.keyword in KINDS]


def build_joints(deck: Deck, model: Model, bodies: Bodies, movable: Array) -> Joints | None:
    """The joints between the bodies; raises DeckError for nodes that cannot make a joint."""
    pairs, body = [], bodies.owner
    for number, entry in enumerate(joint_entries(deck)):
        places = {
            name: _place(model, entry, name, bodies.nodes)
            for name in ("n1", "n2", "n3", "n4")
            if getattr(entry, name)
        }
        _check(model, entry, places, bodies.nodes, body)
        pairs.append(Pair(number, (places["n1"], places["n2"]), None))
        if entry.keyword is CONSTRAINED_JOINT_REVOLUTE:
            pairs.append(Pair(number, (places["n3"], places["n4"]), (places["n1"], places["n3"])))
    return Joints(pairs, bodies, movable) if pairs else None


def _place(model: Model, entry: Entry, name: str, nodes: Index) -> int:
    """The place of a node among those of all bodies."""
    found = np.flatnonzero(nodes == model.row(entry, name, getattr(entry, name)))
    if not found.size:
        what = "no node of a rigid body; joints join rigid bodies: *CONSTRAINED_EXTRA_NODES_NODE adds a node to one"
        raise entry.error(name, what)
    return int(found[0])


def _check(model: Model, entry: Entry, places: dict[str, int], nodes: Index, body: Index) -> None:
    """The nodes of each pair coincide and join the same two bodies; a revolute joint has an axis."""
    x = model.x0[nodes]
    near = COINCIDENT * np.ptp(model.x0, axis=0).max()
    if body[places["n1"]] == body[places["n2"]]:
        raise entry.error("n2", "belongs to the body of N1: a joint joins two")
    for one, other in (("n1", "n2"), ("n3", "n4")):
        if one in places and np.abs(x[places[one]] - x[places[other]]).max() > near:
            raise entry.error(other, f"does not lie where {one.upper()} lies")
    for one, other in (("n1", "n3"), ("n2", "n4")):
        if other in places and body[places[one]] != body[places[other]]:
            raise entry.error(other, f"belongs to another body than {one.upper()}")
    if "n3" in places and np.abs(x[places["n1"]] - x[places["n3"]]).max() <= near:
        raise entry.error("n3", "lies where N1 lies: the joint has no axis")
