"""Channels of the built-in solver: their probes, the energies of a model, and channels that a model does not have."""

from collections.abc import Mapping

from msgspec.structs import asdict

from vmharness.case.format import Channel
from vmharness.deck import Deck, DeckError, Finding
from vmharness.deck.finding import in_order, unsupported
from vmharness.explicit.build import assemble, build
from vmharness.explicit.constraint import Constraint
from vmharness.explicit.energy import STORED, accounts
from vmharness.explicit.force import Force
from vmharness.explicit.model.model import Model
from vmharness.explicit.probes import Probe, ProbeError, probe


def probe_of(model: Model, channel: Channel) -> Probe:
    """The probe of a channel; raises ProbeError if the model has no such quantity."""
    fields = {name: value for name, value in asdict(channel).items() if value is not None}
    del fields["text"]
    return probe(model, **fields)


def findings(deck: Deck, channels: Mapping[str, Channel]) -> list[Finding]:
    """The findings on the deck; if the model can be built, also one for each channel that it does not have."""
    model, found = assemble(deck)
    if model is not None and not unsupported(found):
        for name, channel in channels.items():
            try:
                probe_of(model, channel)
            except ProbeError as error:
                found.append(Finding(DeckError(f"[channels] {name}: {error}")))
    return in_order(deck, found)


def energies(deck: Deck) -> dict[str, Channel]:
    """Kinetic energy, the energies of all forces and constraints, their total, and the energy ratio, as channels."""
    model = build(deck)
    items: list[Force | Constraint] = [*model.forces, *model.constraints]
    kept = [kind for kind in (*STORED, "external work") if accounts(items, kind)]
    return {name: Channel(text=name, energy=name) for name in ("kinetic", *kept, "total", "ratio")}
