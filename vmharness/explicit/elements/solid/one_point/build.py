"""The deck's parts with *SECTION_SOLID ELFORM = 1 -> forces and masses of the model."""

from vmharness.deck import Deck, Entry
from vmharness.deck.error import each
from vmharness.deck.keywords.control.hourglass import CONTROL_HOURGLASS
from vmharness.deck.keywords.hourglass import HOURGLASS
from vmharness.explicit.elements.solid._build import add_part
from vmharness.explicit.elements.solid._parts import solid_parts
from vmharness.explicit.elements.solid.one_point.hourglass import Hourglass, moduli
from vmharness.explicit.elements.solid.one_point.step import step
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part

ELFORM = 1
DEFAULT = 2  # hourglass type where IHQ is 0


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each such part."""

    def add(part: Part) -> None:
        if part.rigid:
            return
        control = _hourglass(deck, part.part)
        modulus = part.moduli.longitudinal
        add_part(
            deck,
            model,
            part,
            step,
            resistance=moduli(model.x0[part.nodes], part.density, modulus, control),
            hourglass=(control.viscous, control.projected),
        )

    each(solid_parts(deck, model, ELFORM), add)


def _hourglass(deck: Deck, part: Entry) -> Hourglass:
    """*HOURGLASS of the part, else *CONTROL_HOURGLASS, else the solver's default."""
    if part.hgid:
        card, coefficient = deck.find(HOURGLASS, hgid=part.hgid, referred_by=(part, "hgid")), "qm"
    elif control := deck.first(CONTROL_HOURGLASS):
        card, coefficient = control, "qh"
    else:
        return Hourglass()
    try:
        return Hourglass(ihq=card.ihq or DEFAULT, qm=getattr(card, coefficient))
    except ValueError as error:
        raise card.error("ihq", str(error)) from None
