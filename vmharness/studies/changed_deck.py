"""Cases with changed entries of the deck, for changes that no parameter can make."""

from collections.abc import Callable, Iterable
from dataclasses import replace

from vmharness.case import Case
from vmharness.case.deck import read_deck
from vmharness.deck import Deck, Entry, write_long
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP


def with_entries(case: Case, change: Callable[[Deck], Iterable[Entry]]) -> Case:
    """The case with the entries that `change` makes of those of its resolved deck; any solver can run this deck.

    Numbers of more than 20 characters lose their last digits, at most 1e-12 of their value (`write_long`). Raises
    DeckError where the case's own deck cannot be read.
    """
    deck = read_deck(case)
    return case.with_deck(write_long(replace(deck, entries=list(change(deck)), _by_name={})))


def with_step(case: Case, factor: float) -> Case:
    """The case with `factor` times its time step: TSSFAC, and DTINIT, of *CONTROL_TIMESTEP.

    Raises DeckError where the step follows a curve.
    """
    return with_entries(case, lambda deck: _scaled(deck, factor))


def with_stiffer_contacts(case: Case, factor: float) -> Case:
    """The case with `factor` times the stiffness of its contacts: SFSA and SFSB of every *CONTACT_..."""

    def stiffer(entry: Entry) -> Entry:
        if not entry.keyword.name.startswith("CONTACT_"):
            return entry
        scales: dict[str, float] = {
            name: factor * entry.values[name] for name in ("sfsa", "sfsb") if name in entry.values
        }
        return replace(entry, values={**entry.values, **scales})

    return with_entries(case, lambda deck: map(stiffer, deck.entries))


def contact_scales(case: Case) -> list[float]:
    """The scale factors of the contact stiffness: SLSFAC, then SFSA and SFSB of each contact."""
    deck = read_deck(case)
    control = deck.first(CONTROL_CONTACT)
    contacts = [entry for entry in deck.entries if entry.keyword.name.startswith("CONTACT_")]
    own = [entry.values[name] for entry in contacts for name in ("sfsa", "sfsb") if name in entry.values]
    return [control.slsfac if control else 0.0, *own]


def _scaled(deck: Deck, factor: float) -> list[Entry]:
    found = deck.first(CONTROL_TIMESTEP)
    control = found or Entry.of_defaults(CONTROL_TIMESTEP)
    if control.lctm:
        raise control.error("lctm", "a step that follows a curve is not scaled")
    scaled = {"tssfac": factor * control.tssfac, "dtinit": factor * control.dtinit}
    other = replace(control, values={**control.values, **scaled})
    if found is None:
        return [other, *deck.entries]
    return [other if entry is found else entry for entry in deck.entries]
