"""Fields of contact cards that are read but act on nothing, here or beside the other fields: said in the run's facts.

A field is said where its value is not the default. What would change the physics is refused, see
supported.py; but for SNLOG = 0, the default, whose logic for shooting nodes no contact here has.
"""

from collections.abc import Iterator, Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

from vmharness import plugins
from vmharness.deck import Deck, Entry, Keyword
from vmharness.explicit.contact.cards import number_of
from vmharness.mesh.surface import ALL

if TYPE_CHECKING:
    from vmharness.explicit.contact.build import Kind

Reason = tuple[tuple[str, ...], str]  # fields, and why they do not act

SHOOTING = "a node that shoots through the surface is not moved back, as with SNLOG = 1 in all contacts"


def of_contact(deck: Deck, entry: Entry, control: Mapping[str, Any], two_way: bool) -> dict[str, str]:
    """The fact, by its name, that fields of a contact do not act; none where all do."""
    name = f"contact {number_of(deck, entry)}"
    facts = _fact(name, entry, of_cards(entry, control, two_way))
    if entry.snlog or _thick(entry, control):
        facts[f"Shooting nodes of {name}"] = SHOOTING
    return facts


def of_control(control: Entry, contacts: list[Entry]) -> dict[str, str]:
    """The same of *CONTROL_CONTACT, which acts on the `contacts` of the deck."""
    return _fact("*CONTROL_CONTACT", control, of_control_cards(contacts))


@cache
def kinds() -> "dict[Keyword, Kind]":
    """The supported contacts by their keywords."""
    found = plugins.modules("vmharness.explicit.contact.kinds", "KIND")
    return {module.KIND.keyword: module.KIND for module in found}


def kind_of(entry: Entry) -> "Kind":
    """Properties of the contact's keyword."""
    return kinds()[entry.keyword]


def _fact(name: str, entry: Entry, reasons: Iterator[Reason]) -> dict[str, str]:
    defaults = _defaults(entry.keyword)
    said = [
        f"{field.upper()} = {entry.values[field]} ({why})"
        for fields, why in reasons
        for field in fields
        if entry.values[field] != defaults[field]
    ]
    return {f"Without effect in {name}": "; ".join(said)} if said else {}


def _defaults(keyword: Keyword) -> dict[str, Any]:
    return {name: value for card in keyword.cards for name, value in card.defaults().items()}


def _thick(entry: Entry, control: Mapping[str, Any]) -> bool:
    return kind_of(entry).automatic or bool(entry.shlthk or control["shlthk"])


def reason(reasons: Iterator[Reason], field: str) -> str:
    """Why a field does not act, or nothing."""
    return next((why for fields, why in reasons if field in fields), "")


def of_cards(entry: Entry, control: Mapping[str, Any], two_way: bool) -> Iterator[Reason]:
    """What does not act beside the other fields of a contact."""
    yield ("sapr", "sbpr", "cid_rcf"), "affects output only"
    yield ("bsort",), "the search interval follows from the nodal velocities"
    yield ("igap",), "acts in implicit analysis only"
    yield ("sbopt", "depth"), "act with SOFT = 2"
    if entry.soft == 0:
        yield ("sofscl",), "acts with SOFT = 1"
    if entry.penchk:
        yield ("penmax",), "PENCHK is used instead"
    if control["penopt"] == 2 and not two_way and not kind_of(entry).single_surface:
        yield ("sfsa",), "PENOPT = 2: the stiffness is that of the segments"
    if kind_of(entry).single_surface:
        yield ("surfb", "sfsb", "sbst", "sfsbt"), "a single surface has no second side"
    for side in "ab":
        if getattr(entry, f"surf{side}typ") == ALL:
            yield (f"surf{side}",), f"SURF{side.upper()}TYP = {ALL} means all parts; the number is not used"
    yield from _of_thickness(entry, control)
    yield from _of_friction(entry)


def _of_thickness(entry: Entry, control: Mapping[str, Any]) -> Iterator[Reason]:
    if kind_of(entry).automatic:
        yield ("shlthk",), "thickness always counts"
    for side in "ab":
        if not _thick(entry, control):
            yield (f"s{side}st", f"sfs{side}t"), "SHLTHK = 0: no thickness counts"
        elif getattr(entry, f"s{side}st"):
            yield (f"sfs{side}t",), f"S{side.upper()}ST is used instead"


def _of_friction(entry: Entry) -> Iterator[Reason]:
    if entry.fs == entry.fd:
        yield ("dc",), "FS = FD"
    elif entry.dc == 0.0:
        yield ("fd",), "DC = 0 keeps friction at FS"
    if not (entry.fs or entry.fd):
        yield ("vc", "fsf", "vsf"), "no friction"
    elif not entry.vc:
        yield ("vsf",), "VC = 0"


def of_control_cards(contacts: list[Entry]) -> Iterator[Reason]:
    """What of *CONTROL_CONTACT does not act on any of the contacts; those that are not supported are left out."""
    contacts = [entry for entry in contacts if entry.keyword in kinds()]
    plain = [entry for entry in contacts if not kind_of(entry).automatic]
    yield ("nsbcs",), "the search interval follows from the nodal velocities"
    yield ("islchk",), "initial penetrations are always looked for"
    yield ("frceng",), "the energy of friction is always kept"
    yield ("skiprwg", "outseg", "ftall"), "affects output only"
    yield ("ecdt",), "acts on eroding contacts"
    yield ("tiedprj",), "acts on tied contacts"
    yield ("rwgaps",), "acts in implicit analysis only"
    yield ("rwpnal",), "acts on rigid bodies at rigid walls"
    if not contacts:
        yield ("slsfac", "penopt"), "no contact"
    if all(entry.ignore for entry in contacts):
        yield ("ignore",), "every contact sets its own IGNORE"
    if not any(entry.penchk == 1 for entry in contacts):
        yield ("xpene",), "acts with PENCHK = 1"
    if not any(kind_of(entry).single_surface for entry in contacts):
        yield ("ssthk",), "acts on single surfaces"
    if not plain:
        yield ("orien",), "acts on contacts that are not automatic"
    if all(entry.shlthk for entry in plain):
        yield ("shlthk",), "every non-automatic contact sets its own SHLTHK, or there is none"
