"""The deck's parts with *SECTION_SOLID ELFORM = 1 -> forces and masses of the model."""

from collections.abc import Callable
from functools import cache
from typing import Any

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.hourglass import CONTROL_HOURGLASS
from vmharness.deck.keywords.hourglass import HOURGLASS
from vmharness.explicit.elements.solid import _stress as stress
from vmharness.explicit.elements.solid._build import add_part
from vmharness.explicit.elements.solid._parts import solid_parts
from vmharness.explicit.elements.solid.one_point import step
from vmharness.explicit.elements.solid.one_point.hourglass import Hourglass, moduli
from vmharness.explicit.kernels.compiled import specialise
from vmharness.explicit.materials._plasticity.long_curves import with_law
from vmharness.explicit.model.model import Model

ELFORM = 1
DEFAULT = 2  # hourglass type where IHQ is 0


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each such part."""
    for part in solid_parts(deck, model, ELFORM):
        if part.rigid:
            continue
        control = _hourglass(deck, part.part)
        modulus = part.moduli.longitudinal
        add_part(
            deck,
            model,
            part,
            compiled,
            resistance=moduli(model.x0[part.nodes], part.density, modulus, control),
            hourglass=(control.viscous, control.projected),
        )


@cache
def compiled(law: Callable[..., Any], long_curve: bool) -> Callable[..., float]:
    """The step for one law; `long_curve`: see materials/_plasticity/long_curves.py."""
    return specialise(step.step, stress_at_point=with_law(stress.stress_at_point, law, long_curve))


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
