"""A part of the deck -> the force of its shells, and their mass."""

from collections.abc import Callable

from vmharness.deck import Deck
from vmharness.deck.keywords.control.shell import CONTROL_SHELL
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.explicit.elements.shell._parts import thickness
from vmharness.explicit.elements.shell._shells import Shells
from vmharness.explicit.materials import law_of
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part

ELFORM = 2


def add_part(deck: Deck, model: Model, part: Part, name: str, shells: Callable[..., Shells]) -> None:
    """Add the force of a part, which `shells` makes, and its lumped mass; `name` is that of such elements.

    Nothing is added for a rigid part: see rigid/elements.py.
    """
    if part.rigid:
        return
    section, timestep = part.section, deck.first(CONTROL_TIMESTEP)
    control = deck.first(CONTROL_SHELL)
    if section.elform != ELFORM:
        raise section.error("elform", f"not implemented; supported: {ELFORM} (Belytschko-Tsay)")
    t = thickness(part)
    law = law_of(part.material, "plane_stress", part.part)
    try:
        block = shells(
            name=f"{name} of part {part.pid}",
            nodes=part.nodes,
            x=model.x0,
            thickness=t,
            density=part.density,
            law=law.plane_stress,
            constants=law.constants(deck, part.material),
            moduli=part.moduli,
            nip=section.nip,
            shrf=section.shrf,
            isdo=timestep.isdo if timestep else 0,
            thinning=bool(control and control.istupd),
            history=law.HISTORY["plane_stress"],
            channels=law.CHANNELS,
            eid=part.eid,
            pid=part.pid,
        )
    except ValueError as error:
        raise part.part.error(None, str(error)) from None
    model.forces.append(block)
    for corner in part.nodes.T:
        model.add_mass(corner, block.mass, block.inertia)
