"""A deck -> its model: nodes first, then what pushes on them and what rules their motion, in an order that matters."""

import numpy as np

from vmharness import plugins
from vmharness.deck import Deck
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.node import NODE
from vmharness.explicit.constraints import prescribed_motion, prescribed_motion_rigid, spc
from vmharness.explicit.contact import control_contact
from vmharness.explicit.damping import mass as mass_damping
from vmharness.explicit.damping import stiffness as stiffness_damping
from vmharness.explicit.initial import velocity, velocity_generation
from vmharness.explicit.kernels.threads import ncpu
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import State
from vmharness.explicit.rigid import build as rigid_bodies
from vmharness.explicit.rigid import elements as rigid_elements
from vmharness.explicit.rigid.numbers import numbers
from vmharness.explicit.timestep import caps, discrete, mass_scaling, penalty
from vmharness.explicit.walls import planar
from vmharness.mesh.nodes import nodes_of


def build(deck: Deck) -> Model:
    """The model of a deck; raises DeckError for what cannot be built, or could move without having mass."""
    model = _nodes(deck)
    _add_all("elements", deck, model)  # first: they make the mass and the stiffness that all others ask for
    rigid_elements.build(deck, model)  # mass alone, of parts that are rigid
    _add_all("contact.kinds", deck, model)  # before velocities: nodes that begin behind a surface are moved
    control_contact.build(deck, model)  # says what of *CONTROL_CONTACT acts on none of these contacts
    _add_all("loads", deck, model)
    velocity.build(deck, model)
    velocity_generation.build(deck, model)  # overrules *INITIAL_VELOCITY where both are allowed
    prescribed_motion.build(deck, model)  # overrules initial velocities
    prescribed_motion_rigid.build(deck, model)
    spc.build(deck, model)  # overrules all of these: a support holds
    mass_damping.build(deck, model)  # acts on the accelerations that supports and motions have left
    stiffness_damping.build(deck, model)
    planar.build(deck, model)  # a wall sees what is then left of the motion along its normal
    caps.build(deck, model)
    discrete.build(deck, model)  # before mass is scaled: what elements leave to springs is a stiffness
    mass_scaling.build(deck, model)  # needs all elements
    penalty.build(deck, model)  # needs the step that is then allowed
    rigid_bodies.build(deck, model)  # last: they take all mass from their nodes
    _check_masses(deck, model)
    _check_histories(deck, model)
    s = model.state
    model.inverse_mass = np.divide(1.0, s.mass, out=np.zeros_like(s.mass), where=s.mass > 0.0)
    model.inverse_inertia = np.divide(1.0, s.inertia, out=np.zeros_like(s.inertia), where=s.inertia > 0.0)
    return model


def _add_all(folder: str, deck: Deck, model: Model) -> None:
    """Let every module of a folder add to the model, in the order of their NAMEs, whatever their files are called."""
    found = plugins.modules(f"vmharness.explicit.{folder}", "NAME", "build")
    for module in sorted(found, key=lambda module: str(module.NAME)):
        module.build(deck, model)


def _nodes(deck: Deck) -> Model:
    nodes, bodies = nodes_of(deck), np.array(numbers(deck), np.int64)
    ids = np.concatenate([nodes.ids, -bodies])
    x = np.concatenate([nodes.x0, np.zeros((bodies.size, 3))])
    n = ids.size
    state = State(x.copy(), np.zeros((n, 3)), np.zeros((n, 3)), np.zeros(n), np.zeros(n))
    termination = deck.one(CONTROL_TERMINATION)
    timestep = deck.first(CONTROL_TIMESTEP)
    return Model(
        ids=ids,
        x0=x,
        state=state,
        end_time=termination.endtim,
        end_cycle=termination.endcyc or np.iinfo(np.int64).max,
        step_factor=timestep.tssfac if timestep else 0.9,
        dtmin=termination.dtmin,
        ncpu=ncpu(deck),
    )


def _check_masses(deck: Deck, model: Model) -> None:
    """A node that could move, but has no mass, would move with infinite acceleration."""
    held = np.zeros((model.ids.size, 6), bool)
    for constraint in model.constraints:
        held |= constraint.fixed
    loose = (model.state.mass <= 0.0) & ~held[:, :3].all(axis=1)
    if not loose.any():
        return
    nid = model.ids[np.flatnonzero(loose)[0]]
    for table in deck.all(NODE):
        for row in np.flatnonzero(table.nid == nid):
            others = f" ({loose.sum()} such nodes)" if loose.sum() > 1 else ""
            raise table.error(
                "nid", f"a free node without mass{others}; give it mass, or support it", int(row)
            )


def _check_histories(deck: Deck, model: Model) -> None:
    """A node whose history the deck asks for must be there: else the name is wrong, or the mesh."""
    for keyword, ids in (("DATABASE_HISTORY_NODE", "ids"), ("DATABASE_HISTORY_NODE_ID", "id1")):
        for table in deck.all(keyword):
            model.find(table, ids, getattr(table, ids))
