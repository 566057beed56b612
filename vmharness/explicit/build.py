"""Build the model of a deck.

The order of the passes is part of the method: a pass reads what earlier ones have set, and in every cycle forces are
added and constraints act in the order in which they were built. Each line of the passes gives the reason for its place.
"""

from collections.abc import Callable, Iterator
from typing import TypeVar

import numpy as np

from vmharness import plugins
from vmharness.deck import Deck, DeckError, Entry
from vmharness.deck.finding import Finding, in_order, refuse_unsupported, unsupported
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.explicit.constraints import prescribed_motion, spc
from vmharness.explicit.contact import build as contacts
from vmharness.explicit.damping import mass as mass_damping
from vmharness.explicit.damping import stiffness as stiffness_damping
from vmharness.explicit.drilling import report_drilling
from vmharness.explicit.initial import velocity
from vmharness.explicit.loose_nodes import rest_loose_nodes
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.rigid_bodies import body_numbers
from vmharness.explicit.rigid import build as rigid_bodies
from vmharness.explicit.rigid import element_mass
from vmharness.explicit.rigid import prescribed_motion as prescribed_motion_rigid
from vmharness.explicit.state import State
from vmharness.explicit.supported import review_cards
from vmharness.explicit.threads import ncpu
from vmharness.explicit.timestep import limits, mass_scaling
from vmharness.explicit.walls import planar
from vmharness.mesh.histories import history_nodes
from vmharness.mesh.nodes import nodes_of


def build(deck: Deck) -> Model:
    """The model of a deck; raises DeckError for input that is not supported, and for a free node without mass."""
    model, findings = assemble(deck)
    findings = in_order(deck, findings)
    refuse_unsupported(findings)
    if model is None:
        raise AssertionError("a deck without a model has findings")
    model.idle = findings
    return model


def review(deck: Deck) -> list[Finding]:
    """All that the solver has to say of a deck: what is not supported, and what has no effect in it."""
    return in_order(deck, assemble(deck)[1])


def assemble(deck: Deck) -> tuple[Model | None, list[Finding]]:
    """The model of a deck as far as it can be built, and what there is to say of its cards and of the model.

    Of a deck in which something is ill-formed, the cards alone are reviewed.
    """
    findings = review_cards(deck)
    if not deck.sound:
        return None, findings
    model = attempt(findings, _nodes, deck)
    if model is None:
        return None, findings
    for add in passes():
        attempt(findings, add, deck, model)
    for add in passes_of_whole_models():
        if not unsupported(findings):
            attempt(findings, add, deck, model)
    findings += model.idle
    s = model.state
    model.inverse_mass = np.divide(1.0, s.mass, out=np.zeros_like(s.mass), where=s.mass > 0.0)
    model.inverse_inertia = np.divide(1.0, s.inertia, out=np.zeros_like(s.inertia), where=s.inertia > 0.0)
    return model, findings


Add = Callable[[Deck, Model], None]
Result = TypeVar("Result")


def passes() -> Iterator[Add]:
    """What adds to a model, in the order of its dependence."""
    yield from _drop_ins("elements")  # first: contacts, steps and rigid bodies read their mass and stiffness
    yield element_mass.build  # with the elements: it completes the mass that rigid bodies sum up
    yield from _drop_ins("contact.kinds")  # before velocities, walls and bodies: IGNORE moves nodes
    yield contacts.report_control  # after the contacts: its fact is listed behind theirs
    yield from _drop_ins("loads")  # before rigid bodies, which check that a load acts on a whole body
    yield velocity.build  # before motions and supports: these overrule initial velocities
    yield prescribed_motion.build  # before those of rigid bodies, whose numbers continue these
    yield prescribed_motion_rigid.build  # before mass damping, which leaves out driven directions
    yield spc.build  # before mass damping, which leaves out supported directions
    yield mass_damping.build  # before walls, which act on the accelerations that damping leaves


def passes_of_whole_models() -> Iterator[Add]:
    """The passes that go on from there; in a model that lacks a part, they would find faults that follow from that."""
    yield planar.build  # after motions: it leaves out nodes that one rules along the normal
    yield stiffness_damping.build  # before mass is scaled: COEF > 0 refers to unscaled steps
    yield limits.add_caps  # before contacts report their steps, which are compared with caps too
    yield lambda deck, model: limits.reserve_mass(model)  # before mass is scaled: m_e/h_e^2 is a stiffness
    yield mass_scaling.build  # after all constraints on nodes, whose velocities it keeps
    yield limits.report_contact_steps  # after mass is scaled: it compares the steps that result
    yield rigid_bodies.build  # after these: it moves the mass of each body from its nodes to its centre
    yield report_drilling  # after all constraints: what these hold does not spin
    yield rest_loose_nodes  # after all that could hold, move or load a node
    yield _check_histories


def attempt(findings: list[Finding], act: Callable[..., Result], *given: object) -> Result | None:
    """The result of `act`; what is wrong becomes a finding, unless it merely follows from those before."""
    before = unsupported(findings)
    try:
        return act(*given)
    except DeckError as error:
        known = {str(other) for other in before} | {_place(other) for other in before if other.field}
        families = {other.keyword.partition("_")[0] for other in before if not other.field}
        for one in error.errors:
            if before and one.keyword and not one.field:  # of values that are no single field's
                continue
            if not (str(one) in known or _place(one) in known or one.sought & families):
                findings.append(Finding(one))
                known.add(str(one))
    except Exception:  # a model in which a part is missing may raise anything
        if not before:
            raise
    return None


def _place(error: DeckError) -> str:
    return f"{error.file}:{error.line} {error.field}"


def _drop_ins(folder: str) -> list[Add]:
    """What the modules of a folder add, in the order of their NAMEs: names of files have no effect."""
    found = plugins.modules(f"vmharness.explicit.{folder}", "NAME", "build")
    return [module.build for module in sorted(found, key=lambda module: str(module.NAME))]


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


def _check_histories(deck: Deck, model: Model) -> None:
    """Every node of *DATABASE_HISTORY_NODE is in the deck."""
    history_nodes(deck, model)
