"""What the parts of elements need: a section of their kind, a material with a law for it, hourglass control."""

from collections.abc import Generator, Iterator, Mapping

from vmharness.deck import Deck, DeckError, Entry, Keyword
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM, ELEMENT_BEAM_ORIENTATION
from vmharness.deck.keywords.element.discrete import ELEMENT_DISCRETE
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.deck.keywords.element.solid import ELEMENT_SOLID
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.beam import RESULTANT, SECTION_BEAM
from vmharness.deck.keywords.section.discrete import SECTION_DISCRETE
from vmharness.deck.keywords.section.shell import SECTION_SHELL
from vmharness.deck.keywords.section.solid import SECTION_SOLID
from vmharness.explicit.materials import law_of, material_of
from vmharness.explicit.references.defined import HOURGLASSES, Defined, distinct

SECTION: Mapping[Keyword, Keyword] = {
    ELEMENT_SOLID: SECTION_SOLID,
    ELEMENT_SHELL: SECTION_SHELL,
    ELEMENT_SHELL_THICKNESS: SECTION_SHELL,
    ELEMENT_BEAM: SECTION_BEAM,
    ELEMENT_BEAM_ORIENTATION: SECTION_BEAM,
    ELEMENT_DISCRETE: SECTION_DISCRETE,
}
STATE = {
    SECTION_SOLID: "solid",
    SECTION_SHELL: "plane_stress",
    SECTION_BEAM: "uniaxial",
    SECTION_DISCRETE: "spring",
}
HOURGLASSED = (SECTION_SOLID, SECTION_SHELL)


def missing_of_parts(deck: Deck, defined: Defined) -> Iterator[DeckError]:
    """An error for each thing that the parts of the deck's elements lack."""
    parts = {part.pid: part for part in deck.all(PART)}
    sections = {(entry.keyword, entry.secid): entry for entry in deck.all(*STATE)}
    for pid, section in _used(deck):
        if part := parts.get(pid):
            yield from _section(deck, part, section, sections)
            material = yield from _material(deck, part)
            rigid = material is not None and material.keyword is MAT_RIGID and section is not SECTION_DISCRETE
            if material and not rigid:
                yield from _law(part, material, section, sections.get((section, part.secid)))
            if section in HOURGLASSED and not rigid:
                yield from defined.missing(part, "hgid", HOURGLASSES)


def _used(deck: Deck) -> Iterator[tuple[int, Keyword]]:
    """Every part that has elements, with the section that these need; each pair once."""
    found: dict[tuple[int, Keyword], None] = {}
    for keyword, section in SECTION.items():
        for table in deck.all(keyword):
            if "pid" in table.values:
                found.update(dict.fromkeys((pid, section) for pid in distinct(table.pid).tolist()))
    yield from found


def _section(
    deck: Deck, part: Entry, section: Keyword, sections: Mapping[tuple[Keyword, int], Entry]
) -> Iterator[DeckError]:
    if part.secid and (section, part.secid) not in sections:
        try:
            deck.find(section, secid=part.secid, referred_by=(part, "secid"))
        except DeckError as error:
            yield error


def _material(deck: Deck, part: Entry) -> Generator[DeckError, None, Entry | None]:
    """The material, if it is defined."""
    try:
        return material_of(deck, part)
    except DeckError as error:
        if part.mid:
            yield error
    return None


def _law(part: Entry, material: Entry, section: Keyword, own: Entry | None) -> Iterator[DeckError]:
    """Whether the material has a law for the elements; resultant beams are elastic."""
    if own and section is SECTION_BEAM and own.elform in RESULTANT:
        if material.keyword is not MAT_ELASTIC:
            what = f"resultant beams support *{MAT_ELASTIC.name} only"
            yield part.error("mid", what)
        return
    try:
        law_of(material, STATE[section], part)
    except DeckError as error:
        yield error
