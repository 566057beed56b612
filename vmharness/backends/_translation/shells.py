"""What adapters support of shells of four nodes."""

from vmharness.deck.keywords.element.shell import ELEMENT_SHELL
from vmharness.deck.keywords.section.shell import SECTION_SHELL
from vmharness.deck.rule import no_effect, only
from vmharness.deck.support import Support, supports


def shells(elform: str, shrf: str, nip: str) -> tuple[Support, ...]:
    """Declare shells, with the sentences that say why ELFORM, SHRF and NIP have no effect."""
    return (
        supports(ELEMENT_SHELL, **{f"n{i}": only(0) for i in range(5, 9)}),
        supports(
            SECTION_SHELL,
            elform=no_effect(elform),
            shrf=no_effect(shrf),
            nip=no_effect(nip),
            icomp=only(0),
            nloc=only(0.0),
            marea=only(0.0),
        ),
    )
