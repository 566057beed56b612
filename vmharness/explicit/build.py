"""Build the model of a deck.

The order of the passes is part of the method: a pass reads what earlier ones have set, and in every cycle forces are
added and constraints act in the order in which they were built. Each line of `build` gives the reason for its place.
"""

import numpy as np

from vmharness import plugins
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.node import NODE
from vmharness.explicit.constraints import prescribed_motion, prescribed_motion_rigid, spc
from vmharness.explicit.contact import build as contacts
from vmharness.explicit.damping import mass as mass_damping
from vmharness.explicit.damping import stiffness as stiffness_damping
from vmharness.explicit.initial import velocity
from vmharness.explicit.kernels.threads import ncpu
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import State
from vmharness.explicit.rigid import build as rigid_bodies
from vmharness.explicit.rigid import element_mass
from vmharness.explicit.rigid.definitions import body_numbers
from vmharness.explicit.timestep import limits, mass_scaling
from vmharness.explicit.walls import planar
from vmharness.mesh.nodes import nodes_of


def build(deck: Deck) -> Model:
    """The model of a deck; raises DeckError for input that is not supported, and for a free node without mass."""
    model = _nodes(deck)
    _add_all("elements", deck, model)  # first: contacts, steps and rigid bodies read their mass and stiffness
    element_mass.build(deck, model)  # with the elements: it completes the mass that rigid bodies sum up
    _add_all("contact.kinds", deck, model)  # before velocities, walls and bodies: IGNORE moves nodes
    contacts.report_control(deck, model)  # after the contacts: its fact is listed behind theirs
    _add_all("loads", deck, model)  # before rigid bodies, which check that a load acts on a whole body
    velocity.build(deck, model)  # before motions and supports: these overrule initial velocities
    prescribed_motion.build(deck, model)  # before those of rigid bodies, whose numbers continue these
    prescribed_motion_rigid.build(deck, model)  # before mass damping, which leaves out driven directions
    spc.build(deck, model)  # before mass damping, which leaves out supported directions
    mass_damping.build(deck, model)  # before walls, which act on the accelerations that damping leaves
    planar.build(deck, model)  # after motions: it leaves out nodes that one rules along the normal
    stiffness_damping.build(deck, model)  # before mass is scaled: COEF > 0 refers to unscaled steps
    limits.add_caps(deck, model)  # before contacts report their steps, which are compared with caps too
    limits.reserve_mass(model)  # before mass is scaled: m_e/h_e^2 is a stiffness, which must not change
    mass_scaling.build(deck, model)  # after all constraints on nodes, whose velocities it keeps
    limits.report_contact_steps(deck, model)  # after mass is scaled: it compares the steps that result
    rigid_bodies.build(deck, model)  # last: it moves the mass of each body from its nodes to its centre
    _check_masses(deck, model)
    _check_histories(deck, model)
    s = model.state
    model.inverse_mass = np.divide(1.0, s.mass, out=np.zeros_like(s.mass), where=s.mass > 0.0)
    model.inverse_inertia = np.divide(1.0, s.inertia, out=np.zeros_like(s.inertia), where=s.inertia > 0.0)
    return model


def _add_all(folder: str, deck: Deck, model: Model) -> None:
    """Build with every module of a folder, in the order of their NAMEs: names of files have no effect."""
    found = plugins.modules(f"vmharness.explicit.{folder}", "NAME", "build")
    for module in sorted(found, key=lambda module: str(module.NAME)):
        module.build(deck, model)


def _nodes(deck: Deck) -> Model:
    nodes, bodies = nodes_of(deck), np.array(body_numbers(deck), np.int64)
    ids = np.concatenate([nodes.ids, -bodies])
    x = np.concatenate([nodes.x0, np.zeros((bodies.size, 3))])
    n = ids.size
    state = State(x.copy(), np.zeros((n, 3)), np.zeros((n, 3)), np.zeros(n), np.zeros(n))
    termination = deck.one(CONTROL_TERMINATION)
    timestep = deck.first(CONTROL_TIMESTEP) or Entry.of_defaults(CONTROL_TIMESTEP)
    return Model(
        ids=ids,
        x0=x,
        state=state,
        end_time=termination.endtim,
        end_cycle=termination.endcyc or np.iinfo(np.int64).max,
        step_factor=timestep.tssfac,
        dtmin=termination.dtmin,
        ncpu=ncpu(deck),
    )


def _check_masses(deck: Deck, model: Model) -> None:
    """Every free node has mass: otherwise its acceleration would be infinite."""
    held = np.zeros((model.ids.size, 6), bool)
    for constraint in model.constraints:
        held |= constraint.fixed
    massless = (model.state.mass <= 0.0) & ~held[:, :3].all(axis=1)
    if not massless.any():
        return
    nid = model.ids[np.flatnonzero(massless)[0]]
    for table in deck.all(NODE):
        for row in np.flatnonzero(table.nid == nid):
            others = f" ({massless.sum()} such nodes)" if massless.sum() > 1 else ""
            raise table.error(
                "nid", f"a free node without mass{others}; give it mass, or support it", int(row)
            )


def _check_histories(deck: Deck, model: Model) -> None:
    """Every node of *DATABASE_HISTORY_NODE is in the deck."""
    for keyword, ids in (("DATABASE_HISTORY_NODE", "ids"), ("DATABASE_HISTORY_NODE_ID", "id1")):
        for table in deck.all(keyword):
            model.find(table, ids, getattr(table, ids))
