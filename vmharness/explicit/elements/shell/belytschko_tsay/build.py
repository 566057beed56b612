"""The deck's quadrilaterals with *SECTION_SHELL ELFORM = 2 -> forces and masses of the model."""

from functools import partial
from typing import Any

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.hourglass import CONTROL_HOURGLASS
from vmharness.deck.keywords.hourglass import HOURGLASS
from vmharness.explicit.elements.shell._build import add_part
from vmharness.explicit.elements.shell._parts import shell_parts
from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import Hourglass
from vmharness.explicit.elements.shell.belytschko_tsay.part import BelytschkoTsay
from vmharness.explicit.model.model import Model

DEFAULT = 2  # hourglass type where IHQ is 0


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each part that has such shells."""
    for part in shell_parts(deck, model, corners=4):
        add_part(deck, model, part, "shells", partial(_shells, deck, part.part))


def _shells(deck: Deck, part: Entry, **given: Any) -> BelytschkoTsay:
    return BelytschkoTsay(hourglass=_hourglass(deck, part), **given)


def _hourglass(deck: Deck, part: Entry) -> Hourglass:
    """*HOURGLASS of the part, else *CONTROL_HOURGLASS, else the solver's default."""
    if part.hgid:
        own = deck.find(HOURGLASS, hgid=part.hgid, referred_by=(part, "hgid"))
        return Hourglass(ihq=own.ihq or DEFAULT, qm=own.qm, qb=own.qb, qw=own.qw)
    control = deck.first(CONTROL_HOURGLASS)
    return (
        Hourglass(ihq=control.ihq or DEFAULT, qm=control.qh, qb=control.qh, qw=control.qh)
        if control
        else Hourglass()
    )
