"""Rigid bodies alone in space, with the step that a curve gives."""

from collections.abc import Callable

import pytest

from vmharness.deck import Deck
from vmharness.explicit.build import build
from vmharness.explicit.model.model import Model
from vmharness.explicit.rigid.bodies import Bodies
from vmharness.explicit.rigid.constraints import RigidBodies

HEAD = """*KEYWORD
*CONTROL_TERMINATION
{end},
*CONTROL_TIMESTEP
,,,,,9
*DEFINE_CURVE
9
0.0,{step}
1e6,{step}
*DEFINE_CURVE
1
0.0,1.0
1e6,1.0
"""

# A block of 2 x 1 x 1/2 with its centre at (1, 1/2, 1/4), of density 8: mass 8, lumped at its corners, so that
# I = m (b^2 + c^2)/4: 2.5, 8.5, 10.
BLOCK = """*PART
block
7,7,7
*SECTION_SOLID
7,1
*MAT_RIGID
7,8.0,100.0,0.3
{cmo}

*ELEMENT_SOLID
1,7
1,2,3,4,5,6,7,8
*NODE
1,0.0,0.0,0.0
2,2.0,0.0,0.0
3,2.0,1.0,0.0
4,0.0,1.0,0.0
5,0.0,0.0,0.5
6,2.0,0.0,0.5
7,2.0,1.0,0.5
8,0.0,1.0,0.5
"""

# A body without any element: what *PART_INERTIA says of it.
FREE = """*SECTION_SOLID
3,1
*MAT_RIGID
3,1.0,100.0,0.3
{cmo}

*NODE
{first},{x},{y},{z}
*CONSTRAINED_EXTRA_NODES_NODE
3,{first}
*PART_INERTIA
free
3,3,3
0.0,0.0,0.0,{mass}
{ixx},0.0,0.0,{iyy},0.0,{izz}
0.0,0.0,0.0,{wx},{wy},{wz}
"""
PLAIN = dict(
    cmo="", first=11, x=1.0, y=0.0, z=0.0, mass=2.0, ixx=1.0, iyy=2.0, izz=3.0, wx=0.0, wy=0.0, wz=0.0
)


@pytest.fixture
def space(deck: Callable[[str], Deck]) -> Callable[..., Model]:
    """The model of keywords, in steps of a given length."""

    def model(keywords: str, end: float = 1.0, step: float = 0.01) -> Model:
        return build(deck(HEAD.format(end=end, step=step) + keywords))

    return model


@pytest.fixture
def constraint() -> Callable[[Model], RigidBodies]:
    """The constraint of a model's rigid bodies."""
    return lambda model: next(item for item in model.constraints if isinstance(item, RigidBodies))


@pytest.fixture
def bodies(constraint: Callable[[Model], RigidBodies]) -> Callable[[Model], Bodies]:
    """The bodies of a model."""
    return lambda model: constraint(model).bodies


@pytest.fixture
def block() -> str:
    """The block, free."""
    return BLOCK.format(cmo="")


@pytest.fixture
def held_block() -> Callable[[int, int], str]:
    """The block held by CON1, CON2."""
    return lambda con1, con2: BLOCK.format(cmo=f"1,{con1},{con2}")


@pytest.fixture
def free() -> Callable[..., str]:
    """A body of given inertia."""
    return lambda **changed: FREE.format(**{**PLAIN, **changed})
