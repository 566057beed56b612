"""Channels as probes of the model, those that a model has, and what keeps the solver from recording them."""

from collections.abc import Mapping

from msgspec.structs import asdict

from vmharness.case.format import Channel
from vmharness.deck import Deck, DeckError
from vmharness.explicit.build import build
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.energy import STORED, accounts
from vmharness.explicit.force import Force
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes import Probe, ProbeError, probe


def probe_of(model: Model, channel: Channel) -> Probe:
    """What shows a channel of a case; raises ProbeError where the model has no such thing."""
    fields = {name: value for name, value in asdict(channel).items() if value is not None}
    del fields["text"]
    return probe(model, **fields)


def refusals(deck: Deck, channels: Mapping[str, Channel]) -> list[str]:
    """Why the model of the deck cannot be built; else each channel that it does not have."""
    try:
        model = build(deck)
    except DeckError as error:
        return [str(error)]
    wrong = []
    for name, channel in channels.items():
        try:
            probe_of(model, channel)
        except ProbeError as error:
            wrong.append(f"[channels] {name}: {error}")
    return wrong


def energies(deck: Deck) -> dict[str, Channel]:
    """Kinetic energy, those of which any force or constraint keeps an account, their total, and the energy ratio."""
    model = build(deck)
    items: list[Force | Constraint] = [*model.forces, *model.constraints]
    kept = [kind for kind in (*STORED, "external work") if accounts(items, kind)]
    return {name: Channel(text=name, energy=name) for name in ("kinetic", *kept, "total", "ratio")}
