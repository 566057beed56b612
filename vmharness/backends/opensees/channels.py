"""Channels as sums of answers of OpenSees: a constant, and terms (function, arguments, factor)."""

from typing import Any

import numpy as np

from vmharness.backends._translation.motions import motions, moved
from vmharness.backends._translation.review import NotReportedError
from vmharness.backends.opensees.model import Model
from vmharness.case.format import Channel
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.beam import SECTION_BEAM
from vmharness.mesh.supports import supported

Term = tuple[str, list[Any], float]
Sum = tuple[float, list[Term]]

AXES = {"x": 1, "y": 2, "z": 3}
MOTION = {
    "displacement": "nodeDisp",
    "coordinate": "nodeDisp",
    "velocity": "nodeVel",
    "acceleration": "nodeAccel",
}


def terms(model: Model, channel: Channel) -> Sum:
    """The channel as a sum; raises NotReportedError."""
    for owner, make in OWNERS.items():
        if getattr(channel, owner) is not None and (owner != "node" or channel.contact is None):
            return make(model, channel)
    raise NotReportedError(f"opensees does not report {channel.text!r}")


def _of_node(model: Model, channel: Channel) -> Sum:
    axis, _, quantity = str(channel.component).partition("-")
    row = next((i for i, nid in enumerate(model.nodes.ids) if nid == channel.node), None)
    if row is None or not model.used[row]:
        raise NotReportedError(f"no node {channel.node} with a mass or an element")
    if quantity not in MOTION or axis not in AXES:
        raise NotReportedError(f"opensees does not report {channel.component!r} of a node")
    start = float(model.nodes.x0[row, AXES[axis] - 1]) if quantity == "coordinate" else 0.0
    return start, [(MOTION[quantity], [channel.node, AXES[axis]], 1.0)]


def _of_discrete(model: Model, channel: Channel) -> Sum:
    for table in model.deck.all(ELEMENT_DISCRETE):
        for eid, offset in zip(table.eid, table.offset, strict=True):
            if eid == channel.discrete and channel.component == "force":
                return 0.0, [("axialForce", [channel.discrete], 1.0)]
            if eid == channel.discrete and channel.component == "elongation":
                return float(offset), [("deformation", [channel.discrete], 1.0)]
    raise NotReportedError(f"opensees does not report {channel.component!r} of spring {channel.discrete}")


def _of_beam(model: Model, channel: Channel) -> Sum:
    deck = model.deck
    for table in deck.all(ELEMENT_BEAM):
        for eid, pid in zip(table.eid, table.pid, strict=True):
            if eid == channel.beam and channel.component in ("axial-force", "axial-stress"):
                section = deck.find(SECTION_BEAM, secid=deck.find(PART, pid=int(pid)).secid)
                factor = 1.0 if channel.component == "axial-force" else 1.0 / section.a
                return 0.0, [("axialForce", [channel.beam], factor)]
    raise NotReportedError(f"opensees does not report {channel.component!r} of beam {channel.beam}")


def _of_support(model: Model, channel: Channel) -> Sum:
    axis, _, quantity = str(channel.component).partition("-")
    if quantity != "force" or axis not in AXES:
        raise NotReportedError(f"opensees does not report {channel.component!r} of supports")
    held = supported(model.deck, model.nodes)[:, AXES[axis] - 1] & model.used
    nodes = [int(nid) for nid in model.nodes.ids[held] if channel.support in ("all", nid)]
    return 0.0, [("nodeReaction", [nid, AXES[axis]], 1.0) for nid in nodes]


def _of_energy(model: Model, channel: Channel) -> Sum:
    if channel.energy != "kinetic" or channel.part is not None:
        raise NotReportedError(f"opensees does not report the energy {channel.energy!r}")
    rows = [row for row in range(model.mass.size) if model.used[row] and model.mass[row]]
    return 0.0, [("kinetic", [model.id(row)], 0.5 * float(model.mass[row])) for row in rows]


def _of_motion(model: Model, channel: Channel) -> Sum:
    axis, _, quantity = str(channel.component).partition("-")
    cards = motions(model.deck)
    if quantity != "force" or axis not in AXES or not 1 <= (channel.motion or 0) <= len(cards):
        raise NotReportedError(f"opensees does not report {channel.component!r} of motion {channel.motion}")
    rows = moved(model.deck, model.nodes, cards[(channel.motion or 0) - 1])
    return 0.0, [("nodeReaction", [model.id(row), AXES[axis]], 1.0) for row in rows]


def _of_centre(model: Model, channel: Channel) -> Sum:
    axis, _, quantity = str(channel.component).partition("-")
    if channel.centre != "all" or quantity not in ("displacement", "velocity", "momentum"):
        raise NotReportedError(f"opensees does not report {channel.component!r} of centre {channel.centre}")
    share = model.mass if quantity == "momentum" else model.mass / model.mass.sum()
    name = MOTION.get(quantity, "nodeVel")
    rows = np.flatnonzero(share).tolist()
    return 0.0, [(name, [model.id(row), AXES[axis]], float(share[row])) for row in rows]


OWNERS = {
    "motion": _of_motion,
    "centre": _of_centre,
    "node": _of_node,
    "discrete": _of_discrete,
    "beam": _of_beam,
    "support": _of_support,
    "energy": _of_energy,
}
