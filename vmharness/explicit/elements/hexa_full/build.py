"""The deck's parts with *SECTION_SOLID ELFORM = 2 -> forces and masses of the model."""

from collections.abc import Callable
from functools import cache
from typing import Any

from vmharness.deck import Deck
from vmharness.explicit.compiled import specialise
from vmharness.explicit.elements.hexa_full import step
from vmharness.explicit.hexahedron import stress
from vmharness.explicit.hexahedron.build import add_part
from vmharness.explicit.model import Model
from vmharness.explicit.plasticity.ahead import with_law
from vmharness.explicit.solids import solid_parts

ELFORM = 2


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each such part."""
    for part in solid_parts(deck, model, ELFORM):
        if part.rigid:
            continue
        add_part(deck, model, part, compiled, points=step.POINTS)


@cache
def compiled(law: Callable[..., Any], ahead: bool) -> Callable[..., float]:
    """The step for one law; `ahead`: see plasticity/ahead.py."""
    return specialise(step.step, stress_at_point=with_law(stress.stress_at_point, law, ahead))
