"""The deck's parts with *SECTION_SOLID ELFORM = 2 -> forces and masses of the model."""

from collections.abc import Callable
from functools import cache
from typing import Any

from vmharness.deck import Deck
from vmharness.explicit.elements.solid import _stress as stress
from vmharness.explicit.elements.solid._build import add_part
from vmharness.explicit.elements.solid._parts import solid_parts
from vmharness.explicit.elements.solid.full import step
from vmharness.explicit.kernels.compiled import specialise
from vmharness.explicit.materials._plasticity.long_curves import with_law
from vmharness.explicit.model.model import Model

ELFORM = 2


def build(deck: Deck, model: Model) -> None:
    """Add a force and the lumped mass for each such part."""
    for part in solid_parts(deck, model, ELFORM):
        if part.rigid:
            continue
        add_part(deck, model, part, compiled, points=step.POINTS)


@cache
def compiled(law: Callable[..., Any], long_curve: bool) -> Callable[..., float]:
    """The step for one law; `long_curve`: see materials/_plasticity/long_curves.py."""
    return specialise(step.step, stress_at_point=with_law(stress.stress_at_point, law, long_curve))
