"""The deck's parts with *SECTION_SHELL ELFORM = 2 -> forces and masses of the model."""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control_hourglass import CONTROL_HOURGLASS
from vmharness.deck.keywords.control_shell import CONTROL_SHELL
from vmharness.deck.keywords.control_timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.hourglass import HOURGLASS
from vmharness.explicit.elements.shell_belytschko_tsay.hourglass import Hourglass
from vmharness.explicit.elements.shell_belytschko_tsay.part import BelytschkoTsay
from vmharness.explicit.material import law_of
from vmharness.explicit.model import Model
from vmharness.explicit.parts import Part
from vmharness.explicit.shells import shell_parts, thickness
from vmharness.explicit.state import Array

ELFORM = 2
DEFAULT = 2  # hourglass type where IHQ is 0


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each such part."""
    for part in shell_parts(deck, model):
        if part.section.elform != ELFORM:
            raise part.section.error("elform", f"not implemented; supported: {ELFORM} (Belytschko-Tsay)")
        t = thickness(part)
        shells = _force(deck, model, part, t)
        model.forces.append(shells)
        for corner in part.nodes.T:
            model.add_mass(corner, shells.mass, shells.inertia)


def _force(deck: Deck, model: Model, part: Part, t: Array) -> BelytschkoTsay:
    material, section, timestep = part.material, part.section, deck.first(CONTROL_TIMESTEP)
    control = deck.first(CONTROL_SHELL)
    law = law_of(material, "plane_stress", part.part)
    try:
        return BelytschkoTsay(
            name=f"shells of part {part.pid}",
            nodes=part.nodes,
            x=model.x0,
            thickness=t,
            density=material.ro,
            law=law.plane_stress,
            constants=law.constants(deck, material),
            stiffness=(material.e, material.pr),
            nip=section.nip,
            shrf=section.shrf,
            hourglass=_hourglass(deck, part.part),
            isdo=timestep.isdo if timestep else 0,
            thinning=bool(control and control.istupd),
            history=law.HISTORY["plane_stress"],
            channels=getattr(law, "CHANNELS", {}),
            eid=part.eid,
            pid=part.pid,
        )
    except ValueError as error:
        raise part.part.error(None, str(error)) from None


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
