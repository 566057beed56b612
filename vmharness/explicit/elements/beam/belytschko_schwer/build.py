"""The deck's parts with *SECTION_BEAM ELFORM = 2 -> forces and masses of the model."""

from vmharness.deck import Deck
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.explicit.elements.beam._parts import beam_parts, lengths, orientations
from vmharness.explicit.elements.beam.belytschko_schwer.inertia import lumped, stable_step
from vmharness.explicit.elements.beam.belytschko_schwer.part import BelytschkoSchwer
from vmharness.explicit.elements.beam.belytschko_schwer.stiffness import CrossSection, stiffness
from vmharness.explicit.model.model import Model

ELFORM = 2


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each such part; raises DeckError where the material is not elastic."""
    for part in beam_parts(deck, model, ELFORM):
        if part.rigid:
            continue
        if part.material.keyword is not MAT_ELASTIC:
            raise part.part.error("mid", f"beams of resultants are elastic: *{MAT_ELASTIC.name} is supported")
        e, nu = part.moduli
        length, density, card = lengths(part, model.x0), part.density, part.section
        section = CrossSection(card.a, card.iss, card.itt, card.j, card.sa)
        mass, inertia = lumped(length, section, density)
        for end in part.nodes.T:
            model.add_mass(end, mass, inertia)
        model.forces.append(
            BelytschkoSchwer(
                name=f"beams of part {part.pid}",
                nodes=part.nodes,
                x=model.x0,
                orientation=orientations(part, model),
                stiffness=stiffness(length, section, e, nu),
                limit=stable_step(length, section, e, nu, density),
                mass=mass,
                inertia=inertia,
                area=card.a,
                eid=part.eid,
                pid=part.pid,
            )
        )
