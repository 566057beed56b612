"""A part of the deck -> the force of its solids, and their mass."""

from collections.abc import Callable
from typing import Any

from vmharness.deck import Deck
from vmharness.explicit.elements.solid._parts import bulk_viscosity
from vmharness.explicit.elements.solid._solids import Hexahedra
from vmharness.explicit.materials import law_of
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part


def add_part(deck: Deck, model: Model, part: Part, step: Callable[..., float], **formulation: Any) -> None:
    """Add the force of a part and its lumped mass; `step` is that of its formulation."""
    law = law_of(part.material, "solid", part.part)
    block = Hexahedra(
        name=f"solids of part {part.pid}",
        step=step,
        law=law.solid,
        nodes=part.nodes,
        x=model.x0,
        density=part.density,
        modulus=part.moduli.longitudinal,
        constants=law.constants(deck, part.material),
        viscous=bulk_viscosity(deck, part.part),
        history=law.HISTORY["solid"],
        channels=law.CHANNELS,
        eid=part.eid,
        pid=part.pid,
        **formulation,
    )
    model.forces.append(block)
    for corner in part.nodes.T:
        model.add_mass(corner, block.mass)
