"""What the adapters share that translate a deck, entry by entry, for another solver."""

from collections.abc import Callable, Iterable, Mapping
from types import ModuleType
from typing import TypeVar

from vmharness.case.format import Channel
from vmharness.deck import Deck, DeckError, Finding, support
from vmharness.deck.finding import in_order, refuse_unsupported, unsupported
from vmharness.deck.keywords import database
from vmharness.deck.keywords.boundary.spc import BOUNDARY_SPC_NODE, BOUNDARY_SPC_SET
from vmharness.deck.keywords.comment import COMMENT
from vmharness.deck.keywords.control.energy import CONTROL_ENERGY
from vmharness.deck.keywords.control.output import CONTROL_OUTPUT
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.define.curve import DEFINE_CURVE
from vmharness.deck.keywords.node import NODE
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.set.node import SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE
from vmharness.deck.keywords.title import TITLE
from vmharness.deck.rule import only
from vmharness.deck.support import Support, Supported, supports, without_effect
from vmharness.mesh.nodes import Nodes, nodes_of

OUTPUT = (*database.KEYWORDS, COMMENT, CONTROL_ENERGY, CONTROL_OUTPUT, TITLE)
TRANSLATED = (NODE, PART, DEFINE_CURVE, SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE)

Model = TypeVar("Model")
Plan = TypeVar("Plan")


class NotReportedError(ValueError):
    """A solver, as it is driven here, does not give a quantity."""


def declared(modules: Iterable[ModuleType], *others: Support) -> Supported:
    """SUPPORTS of an adapter's modules, with what all adapters support: nodes, sets, supports, requests of output."""
    common = [
        *(without_effect(keyword, "asks for output; no effect on results.") for keyword in OUTPUT),
        *(supports(keyword) for keyword in TRANSLATED),
        *(supports(keyword, cid=only(0)) for keyword in (BOUNDARY_SPC_NODE, BOUNDARY_SPC_SET)),
        supports(CONTROL_TERMINATION, endcyc=only(0), endeng=only(0.0)),
    ]
    return support.by_name([*common, *others, *(each for module in modules for each in module.SUPPORTS)])


def built(
    deck: Deck, supported: Supported, empty: Callable[[Deck, Nodes], Model], passes: Iterable[ModuleType]
) -> Model:
    """The model to which each pass has added what it translates; raises DeckError for what cannot be represented."""
    refuse_unsupported(support.review(deck, supported))
    model = empty(deck, nodes_of(deck))
    for module in passes:
        module.add(deck, model)
    return model


def reviewed(
    deck: Deck,
    channels: Mapping[str, Channel],
    supported: Supported,
    model_of: Callable[[Deck], Model],
    plan: Callable[[Model, Channel], object],
) -> list[Finding]:
    """What of the deck is not represented, which channels are not reported, and what has no effect."""
    found = support.review(deck, supported)
    if unsupported(found):
        return in_order(deck, found)
    try:
        model = model_of(deck)
    except DeckError as error:
        return in_order(deck, [*found, *map(Finding, error.errors)])
    _, missing = planned(model, channels, plan)
    found += [Finding(DeckError(f"[channels] {name}: {why}")) for name, why in missing.items()]
    return in_order(deck, found)


def planned(
    model: Model, channels: Mapping[str, Channel], plan: Callable[[Model, Channel], Plan]
) -> tuple[dict[str, Plan], dict[str, str]]:
    """How each channel is had, and why others are not reported; by name."""
    found: dict[str, Plan] = {}
    missing: dict[str, str] = {}
    for name, channel in channels.items():
        try:
            found[name] = plan(model, channel)
        except NotReportedError as error:
            missing[name] = str(error)
    return found, missing
