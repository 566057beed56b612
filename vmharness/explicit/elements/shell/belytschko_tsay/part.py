"""Belytschko-Tsay shells: those of one part as a force, and from the deck."""

from collections.abc import Callable
from functools import partial
from typing import Any

from vmharness.deck import Deck, Entry
from vmharness.deck.error import each
from vmharness.deck.keywords.control.hourglass import CONTROL_HOURGLASS
from vmharness.deck.keywords.hourglass import HOURGLASS
from vmharness.deck.rule import among, at_least, no_effect
from vmharness.deck.support import supports
from vmharness.explicit.elements.shell._build import add_part
from vmharness.explicit.elements.shell._formulation import Formulation
from vmharness.explicit.elements.shell._parts import shell_parts
from vmharness.explicit.elements.shell._shells import Shells
from vmharness.explicit.elements.shell.belytschko_tsay.frame import load_corners
from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import Hourglass
from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import moduli as hourglass_moduli
from vmharness.explicit.elements.shell.belytschko_tsay.length import LENGTHS
from vmharness.explicit.elements.shell.belytschko_tsay.mass import nodal_mass
from vmharness.explicit.elements.shell.belytschko_tsay.step import force, hourglass_force, strain
from vmharness.explicit.kernels.simd import by_element
from vmharness.explicit.materials import Moduli
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part
from vmharness.explicit.state import Array, Index

SUPPORTS = (
    supports(CONTROL_HOURGLASS, ihq=among(*range(7)), qh=at_least(0.0)),
    supports(
        HOURGLASS,
        ihq=among(*range(7)),
        ibq=no_effect("is not used"),
        **{name: at_least(0.0) for name in ("qm", "q1", "q2", "qb", "qw")},
    ),
)

DEFAULT = 2  # hourglass type where IHQ is 0

QUADRILATERAL = Formulation(nodal_mass, load_corners, LENGTHS, strain, hourglass_force, force)


class BelytschkoTsay(Shells):
    """Shells (ne, 4), see shell/_shells.py, with `hourglass` control that takes E and nu of `moduli`."""

    def __init__(
        self,
        name: str,
        nodes: Index,
        x: Array,
        thickness: Array,
        density: float,
        law: Callable[..., Any],
        constants: tuple[Any, ...],
        moduli: Moduli,
        nip: int = 2,
        shrf: float = 1.0,
        hourglass: Hourglass | None = None,
        isdo: int = 0,
        **options: Any,
    ) -> None:
        control = hourglass or Hourglass()
        super().__init__(
            QUADRILATERAL, name, nodes, x, thickness, density, law, constants, moduli, nip, shrf, isdo,
            hourglass_moduli=lambda: hourglass_moduli(x[nodes], thickness, density, moduli, shrf, control).T,
            viscous=control.viscous, forces=5, **options,
        )  # fmt: skip

    @property
    def hourglass(self) -> Array:
        """Hourglass forces x, y, z and moments x, y (ne, 5) in the elements' frames."""
        return by_element(self._hourglass, self.elements)


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each part that has such shells."""

    def add(part: Part) -> None:
        add_part(deck, model, part, "shells", partial(_shells, deck, part.part))

    each(shell_parts(deck, model, corners=4), add)


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
