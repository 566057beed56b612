"""Cards of a contact and of *CONTROL_CONTACT: number, control fields by name, options of the mechanics."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.explicit.contact.parameters import Options


def contacts_of(deck: Deck) -> list[Entry]:
    """All contacts of the deck, in its order."""
    return [entry for entry in deck.entries if entry.keyword.name.startswith("CONTACT_")]


def number_of(deck: Deck, entry: Entry) -> int:
    """CID, or the place of the contact among all of the deck; raises DeckError where another has the same number."""
    contacts = contacts_of(deck)
    numbers = [other.cid or place for place, other in enumerate(contacts, 1)]
    number = entry.cid or contacts.index(entry) + 1
    if numbers.count(number) > 1:
        raise entry.error("cid", "another contact has this number; give each its own by _ID")
    return number


def control_of(deck: Deck) -> Mapping[str, Any]:
    """The fields of *CONTROL_CONTACT by name, with their defaults where the deck has none."""
    control = deck.first(CONTROL_CONTACT)
    if control:
        return control.values
    return {name: value for card in CONTROL_CONTACT.cards for name, value in card.defaults().items()}


def options_of(entry: Entry, control: Mapping[str, Any]) -> Options:
    """Friction FSF FS and FSF FD, limited by the shear stress VSF VC; damping, birth and death, SOFT, IGNORE."""
    if entry.fs == 2.0:
        raise entry.error("fs", "stands for a table of friction coefficients, which is not supported")
    if entry.dt <= entry.bt:
        raise entry.error("dt", f"the contact would end before its birth at {entry.bt:g}")
    return Options(
        slsfac=control["slsfac"],
        soft=entry.soft,
        sofscl=entry.sofscl,
        fs=entry.fsf * entry.fs,
        fd=entry.fsf * entry.fd,
        dc=entry.dc,
        vc=entry.vsf * entry.vc if entry.vc > 0.0 else np.inf,
        vdc=entry.vdc,
        bt=entry.bt,
        dt=entry.dt,
        maxpar=entry.maxpar,
        ignore=keeps_penetrations(entry, control),
    )


def keeps_penetrations(entry: Entry, control: Mapping[str, Any]) -> bool:
    """Whether initial penetrations stay, as offsets of the gap: IGNORE of card C, or else of *CONTROL_CONTACT."""
    return bool(entry.ignore or control["ignore"])
